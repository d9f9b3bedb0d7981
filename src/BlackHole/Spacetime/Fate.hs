{-# LANGUAGE DeriveFunctor #-}

-- | The ways in which a light path can end.
module BlackHole.Spacetime.Fate
  ( Fate (..),
    fateName,
  )
where

-- | The end of a path that is followed backwards from the camera. The direction of
-- escape is a vector in space, or in the plane of the path.
data Fate direction
  = -- | The path crosses the horizon: no light arrives along it.
    Captured
  | -- | The path leaves for the sky in this direction (of unit length). The direction
    -- does not depend on where the computation stopped, because the sky is infinitely
    -- far away.
    Escaped !direction
  | -- | The path approaches a photon orbit for ever, which happens only for a start that
    -- is critical to the last bit. It counts as dark.
    Circles
  | -- | Gas in front hides the rest of the path.
    Opaque
  | -- | The path used up the allowed number of steps, usually close to the photon
    -- sphere. It counts as dark.
    StepLimit
  deriving (Eq, Show, Functor)

-- | The name used in reports and files.
fateName :: Fate direction -> String
fateName fate = case fate of
  Captured -> "captured"
  Escaped _ -> "escaped"
  Circles -> "circles"
  Opaque -> "opaque"
  StepLimit -> "step limit"
