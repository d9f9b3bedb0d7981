-- | Independent seeds for everything random in a scene, from the scene's own.
module BlackHole.Trace.Seeds
  ( Purpose (..),
    purposeSeed,
  )
where

import BlackHole.Noise.PerlinG (Seed (..))
import BlackHole.Noise.SipHash (SipKey (..), sipHash2)
import Data.Word (Word64)

-- | What the randomness is for. The order is part of every picture: add at
-- the end.
data Purpose
  = ArmDisplacement
  | GasTurbulence
  | StarField
  | StarColour
  | StarPlaces
  | GalacticClouds
  deriving (Eq, Show, Enum, Bounded)

-- | The seed of one purpose under a scene's seed.
purposeSeed :: Word64 -> Purpose -> Seed
purposeSeed seed purpose =
  Seed (sipHash2 (SipKey seed 0x707572706f7365) 0 (fromIntegral (fromEnum purpose)))
