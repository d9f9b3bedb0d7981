-- | How a light path ends: a closed list.
module BlackHole.Physics.Fate
  ( Fate (..),
    fateName,
  )
where

import BlackHole.Vector.XYZ (XYZ)

-- | The end of a path that is followed backwards from the camera.
data Fate
  = -- | It crosses the horizon: no light arrives along it.
    Captured
  | -- | It leaves for the sky in this direction (unit length). Never the
    -- point it happened to stop at: the sky is infinitely far away.
    Escaped !XYZ
  | -- | What lies in front hides the rest.
    Opaque
  | -- | The allowed number of steps was spent, close to the photon sphere as
    -- a rule. It counts as dark.
    StepLimit
  deriving (Eq, Show)

-- | The name that reports and files use.
fateName :: Fate -> String
fateName fate = case fate of
  Captured -> "captured"
  Escaped _ -> "escaped"
  Opaque -> "opaque"
  StepLimit -> "step limit"
