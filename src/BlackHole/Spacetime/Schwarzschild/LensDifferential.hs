{-# LANGUAGE BangPatterns #-}

-- | How the directions in which neighbouring light rays reach the celestial sphere
-- differ.
module BlackHole.Spacetime.Schwarzschild.LensDifferential
  ( lensChange,
    LensChanges (..),
    lensChanges,
  )
where

import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Schwarzschild.LensTable
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ

-- | @lensChange table photon direction neighbour@ is the first-order change of the
-- direction in which a photon of unit energy escapes, towards a neighbour that starts
-- at the same position. The result is a vector tangent to the celestial sphere at
-- @direction@. The neighbour's path turns within its plane by the derivative of the
-- swept angle ('lensSlope'), and its plane differs. 'Nothing' if the photon does not
-- escape, moves radially, or is too close to the critical path.
lensChange :: LensTable -> Photon -> XYZ -> Photon -> Maybe XYZ
lensChange table photon direction neighbour =
  (\(LensChanges change _) -> change) <$> lensChanges table photon direction neighbour neighbour

-- | The changes towards two neighbours.
data LensChanges
  = LensChanges
      {-# UNPACK #-} !XYZ
      {-# UNPACK #-} !XYZ

-- | 'lensChange' towards two neighbours at once, in less than twice the time.
lensChanges :: LensTable -> Photon -> XYZ -> Photon -> Photon -> Maybe LensChanges
lensChanges table (Photon place velocity) direction (Photon _ velocity1) (Photon _ velocity2)
  | not (r > 0 && tangential > 0) = Nothing
  | otherwise = case lensSlope table radial tangential of
    Nothing -> Nothing
    Just !slope ->
      let !offset = lensOffset table radial tangential
          -- Along the path's own turning, and out of its plane.
          !inPlane = XYZ.dot direction e1 *^ e2 ^-^ sine *^ e1
          towards v
            | tangential' > 0 = Just (turning *^ inPlane ^+^ (sine * XYZ.dot v e3 / tangential') *^ e3)
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
    !r = XYZ.norm place
    !e1 = (1 / r) *^ place
    !radial = XYZ.dot velocity e1
    !across = velocity ^-^ radial *^ e1
    !tangential = XYZ.norm across
    !e2 = (1 / tangential) *^ across
    !e3 = XYZ.cross e1 e2
    !sine = XYZ.dot direction e2
