-- | Independent seeds for everything random in a scene, derived from the scene's seed.
module BlackHole.Trace.Seeds
  ( Purpose (..),
    purposeSeed,
  )
where

import BlackHole.Noise.PerlinG (Seed (..))
import BlackHole.Noise.SipHash (SipKey (..), sipHash2)
import Data.Word (Word64)

-- | The use of the random numbers. Every picture depends on the order of the
-- constructors, so add new ones at the end.
data Purpose
  = ArmDisplacement
  | GasTurbulence
  | StarField
  | StarColour
  | StarPlaces
  | GalacticClouds
  deriving (Eq, Show, Enum, Bounded)

-- | The seed for one purpose under a scene's seed.
purposeSeed :: Word64 -> Purpose -> Seed
purposeSeed seed purpose =
  Seed (sipHash2 (SipKey seed 0x707572706f7365) 0 (fromIntegral (fromEnum purpose)))
