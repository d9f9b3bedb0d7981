-- | Where neighbouring light rays end on the celestial sphere.
module BlackHole.Physics.LensBeam
  ( lensChange,
  )
where

import BlackHole.Physics.LensTable
import BlackHole.Physics.Photon
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ

-- | @lensChange table photon direction neighbour@: how the direction in which a
-- photon of unit energy escapes changes towards a neighbour that starts at the
-- same place, to first order: a vector tangent to the celestial sphere at the
-- direction. The neighbour's path turns within its plane by the slope of the
-- swept angle ('lensTurning'), and its plane is another. 'Nothing' where the
-- photon does not escape, has no plane, or is too close to the critical one.
lensChange :: LensTable -> Photon -> XYZ -> Photon -> Maybe XYZ
lensChange table (Photon place velocity) direction (Photon _ velocity') = do
  e1 <- XYZ.normalize place
  let radial = XYZ.dot velocity e1
      across = velocity ^-^ radial *^ e1
      radial' = XYZ.dot velocity' e1
      across' = velocity' ^-^ radial' *^ e1
  e2 <- XYZ.normalize across
  e2' <- XYZ.normalize across'
  turning <- lensTurning table (radial, XYZ.norm across) (radial', XYZ.norm across')
  let cosine = XYZ.dot direction e1
      sine = XYZ.dot direction e2
      e3 = XYZ.cross e1 e2
  pure (turning *^ (cosine *^ e2 ^-^ sine *^ e1) ^+^ (sine * XYZ.dot e2' e3) *^ e3)
