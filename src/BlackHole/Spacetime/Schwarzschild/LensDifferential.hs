{-# LANGUAGE BangPatterns #-}

-- | How the directions in which neighbouring light rays reach the celestial sphere
-- differ.
module BlackHole.Spacetime.Schwarzschild.LensDifferential
  ( LensChanges (..),
    lensChanges,
  )
where

import BlackHole.Spacetime.PathPlane
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Schwarzschild.LensTable
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ

-- | The changes towards two neighbours.
data LensChanges
  = LensChanges
      {-# UNPACK #-} !XYZ
      {-# UNPACK #-} !XYZ

-- | @lensChanges table photon direction neighbour neighbour@ are the first-order changes
-- of the direction in which a photon of unit energy escapes, towards two neighbours that
-- start at the same position. They are vectors tangent to the celestial sphere at
-- @direction@. A neighbour's path turns within its plane by the derivative of the swept
-- angle ('lensSlope'), and its plane differs. 'Nothing' if the photon does not escape or
-- is too close to the critical path.
lensChanges :: LensTable -> Photon -> XYZ -> Photon -> Photon -> Maybe LensChanges
lensChanges table photon direction (Photon _ velocity1) (Photon _ velocity2) =
  case lensSlope table radial tangential of
    Nothing -> Nothing
    Just !slope ->
      let !offset = lensOffset table radial tangential
          -- Along the path's own turning, and out of its plane.
          !inPlane = XYZ.dot direction e1 *^ e2 ^-^ sine *^ e1
          towards v
            | tangential' > 0 =
              Just (turning *^ inPlane ^+^ (sine * XYZ.dot v e3 / tangential') *^ e3)
            | otherwise = Nothing
            where
              !radial' = XYZ.dot v e1
              !tangential' = XYZ.norm (v ^-^ radial' *^ e1)
              !turning = slope * (lensOffset table radial' tangential' - offset)
          {-# INLINE towards #-}
       in case towards velocity1 of
            Just change1 | Just change2 <- towards velocity2 -> Just (LensChanges change1 change2)
            _ -> Nothing
  where
    !(Launch (PathPlane e1 e2) radial tangential) = launch (lensTableRadius table) photon
    !e3 = XYZ.cross e1 e2
    !sine = XYZ.dot direction e2
