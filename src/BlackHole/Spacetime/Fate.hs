-- | The ways in which a light path can end.
module BlackHole.Spacetime.Fate
  ( Fate (..),
    fateName,
  )
where

import BlackHole.Vector.XYZ (XYZ)

-- | The end of a path that is followed backwards from the camera.
data Fate
  = -- | The path crosses the horizon: no light arrives along it.
    Captured
  | -- | The path leaves for the sky in this direction (of unit length). The direction
    -- does not depend on where the computation stopped, because the sky is infinitely
    -- far away.
    Escaped !XYZ
  | -- | Gas in front hides the rest of the path.
    Opaque
  | -- | The path used up the allowed number of steps, usually close to the photon
    -- sphere. It counts as dark.
    StepLimit
  deriving (Eq, Show)

-- | The name used in reports and files.
fateName :: Fate -> String
fateName fate = case fate of
  Captured -> "captured"
  Escaped _ -> "escaped"
  Opaque -> "opaque"
  StepLimit -> "step limit"
