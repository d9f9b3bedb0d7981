{-# LANGUAGE BangPatterns #-}

-- | A table of where the light that arrives at one point around a rotating hole comes
-- from.
--
-- /The parameters/ of a ray are polar coordinates of its direction in Carter's frame, in
-- which @κ@ is the squared tangential momentum: the angle ψ from the outward principal
-- null direction, as @w = tan(ψ\/4)@ as in
-- "BlackHole.Spacetime.Schwarzschild.LensFamily", and the angle ε around it. They follow
-- from the ray's constants of motion, so that one table serves observers in any motion.
--
-- /The edge of the shadow/ is a curve @w = w_c(ε)@. Near it light winds around the photon
-- orbits and everything varies as the logarithm of the distance. The table therefore
-- holds the direction of escape as a function of ε and of @ln (1 − w\/w_c)@, as
-- polynomials on rectangles that are halved until they are accurate
-- ("BlackHole.Vector.Patch"). A rectangle is computed when the first ray falls into it,
-- so a picture pays only for the part of the sky that it shows.
--
-- /The closed form/ ("BlackHole.Spacetime.Kerr.Path") serves where the table does not:
-- closer to the edge than 'closest', at and inside the horizon, and where halving does
-- not help.
module BlackHole.Spacetime.Kerr.SkyTable
  ( SkyTable,
    skyTable,
    tabulatedFate,
    tabulatedChanges,
    tabulatedOffset,
  )
where

import BlackHole.Numeric.Angle (arcTangent2, quarterTangent)
import BlackHole.Numeric.Bisection (bisect)
import BlackHole.Numeric.Floor (turnFraction)
import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Kerr.Path
import BlackHole.Spacetime.Kerr.RadialPotential (lightEscapes)
import BlackHole.Spacetime.Kerr.Sight
import BlackHole.Spacetime.Schwarzschild.LensDifferential (LensChanges (..))
import BlackHole.Vector.Patch
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^))
import Data.Primitive.Array (Array, arrayFromListN, indexArray, sizeofArray)

-- | The table of a point.
data SkyTable = SkyTable
  { _tableSpin :: !Spin,
    _tablePlace :: !Place,
    -- | cos θ and √Δ of the place.
    _tableCosine :: {-# UNPACK #-} !Double,
    _tableRootDelta :: {-# UNPACK #-} !Double,
    -- | By ε in equal parts of the circle from −π on; empty at and inside the horizon.
    _tableSectors :: !(Array Sector)
  }

-- | A range of ε.
data Sector
  = -- | The edge of the shadow, and the directions of escape by ranges of
    -- @−ln (1 − w\/w_c)@ from 0 on.
    Sector !Curve !(Array Patch)
  | -- | Halves below and above an angle.
    Halves {-# UNPACK #-} !Double Sector Sector
  | -- | Where the edge is not smooth enough.
    NoSector

-- | The table of a place. Takes no time by itself: its parts are computed as they are
-- used, one in about 0.1 milliseconds.
skyTable :: Spin -> Place -> SkyTable
skyTable hole place
  | placeRadius place > horizonRadius hole =
    prepared . arrayFromListN sectorCount $
      [ sector (5 :: Int) (sectorWidth * (fromIntegral i + 0.5) - pi) (0.5 * sectorWidth)
        | i <- [0 .. sectorCount - 1]
      ]
  | otherwise = prepared (arrayFromListN 0 [])
  where
    prepared =
      SkyTable
        hole
        place
        (cos (placePolarAngle place))
        (sqrt (kerrDelta hole (placeRadius place)))
    sector depth middle half = case curve 1e-11 16 (edgeAt hole place) middle half of
      Just edge ->
        Sector edge . arrayFromListN rangeCount $
          [ patch tolerance 6 (escape edge) (Rectangle (range k) (0.5 * rangeWidth) middle half)
            | k <- [0 .. rangeCount - 1]
          ]
      Nothing
        | depth > 0 ->
          let part centre = sector (depth - 1) centre (0.5 * half)
           in Halves middle (part (middle - 0.5 * half)) (part (middle + 0.5 * half))
        | otherwise -> NoSector
    range k = rangeWidth * (fromIntegral k + 0.5)
    escape edge x epsilon = do
      ray <- rayTowards hole place (curveValue edge epsilon * (1 - exp (negate x))) epsilon
      case kerrFate (kerrPathWith PicturePrecision hole (BoyerLindquist 0) ray) of
        Escaped direction -> Just direction
        _ -> Nothing

sectorCount, rangeCount :: Int
sectorCount = 8
rangeCount = 12

sectorWidth, rangeWidth :: Double
sectorWidth = 2 * pi / fromIntegral sectorCount
rangeWidth = 2 * log 2

-- | The polynomials' error in each component of the direction.
tolerance :: Double
tolerance = 3e-6

-- | The distance from the edge, relative to @w_c@, below which the table does not apply.
closest :: Double
closest = exp (negate rangeWidth * fromIntegral rangeCount)

-- | @w_c@ at an angle ε: light with a smaller @w@ comes from the sky.
edgeAt :: Spin -> Place -> Double -> Double
edgeAt hole place epsilon = bisect (maybe False (lightEscapes hole) . ray) 0 1
  where
    ray w = rayTowards hole place w epsilon

-- | The ray with the parameters @w@ and ε at a place outside the horizon; 'Nothing' for
-- light that would have no energy at infinity, inside the ergosphere.
rayTowards :: Spin -> Place -> Double -> Double -> Maybe LightRay
rayTowards hole (Place r polarAngle) w epsilon
  | share > 0 =
    Just
      LightRay
        { rayRadius = r,
          rayCosine = c,
          raySine = s,
          rayRadialRate = (halfCosine - halfSine) * (halfCosine + halfSine) * p,
          rayPolarRate = polar,
          rayLambda = l * s,
          rayEta = polar * polar + c * c * (l * l - a * a),
          rayKappa = k * k,
          rayObserved = 1
        }
  | otherwise = Nothing
  where
    a = spinLength hole
    c = cos polarAngle
    s = max 1e-100 (sin polarAngle)
    -- Of ψ/2.
    halfCosine = (1 - w * w) / (1 + w * w)
    halfSine = 2 * w / (1 + w * w)
    -- √κ over P.
    slope = 2 * halfCosine * halfSine / sqrt (kerrDelta hole r)
    share = 1 + a * s * slope * cos epsilon
    p = (r * r + a * a * c * c) / share
    k = slope * p
    polar = k * sin epsilon
    l = a * s + k * cos epsilon

-- | The parameters of a ray at the table's place.
data Parameters = Parameters {-# UNPACK #-} !Double {-# UNPACK #-} !Double

parametersOf :: SkyTable -> LightRay -> Parameters
parametersOf (SkyTable hole _ _ rootDelta _) ray =
  Parameters
    ( quarterTangent
        (rayRadialRate ray * scale)
        (rootDelta * sqrt (across * across + polar * polar) * scale)
    )
    (arcTangent2 polar across)
  where
    a = spinLength hole
    lambda = rayLambda ray
    scale = 1 / (rayRadius ray * rayRadius ray + a * (a - lambda))
    across = lambda / raySine ray - a * raySine ray
    polar = rayPolarRate ray
{-# INLINE parametersOf #-}

-- | Whether a table is that of the place from which a ray is seen, to rounding.
tableServes :: SkyTable -> LightRay -> Bool
tableServes (SkyTable _ (Place r _) cosine _ _) ray =
  abs (rayRadius ray - r) <= 1e-11 * r && abs (rayCosine ray - cosine) <= 1e-11

-- | The sector of a ray, with its parameters.
data AtAngle = AtAngle !Sector {-# UNPACK #-} !Double {-# UNPACK #-} !Double

sectorOf :: SkyTable -> LightRay -> Maybe AtAngle
sectorOf table@(SkyTable _ _ _ _ sectors) ray
  | sizeofArray sectors == 0 || not (tableServes table ray) = Nothing
  | otherwise = go (indexArray sectors (max 0 (min (sectorCount - 1) number)))
  where
    number = truncate ((epsilon + pi) / sectorWidth)
    !(Parameters w epsilon) = parametersOf table ray
    go sector = case sector of
      Halves middle low high -> go (if epsilon < middle then low else high)
      _ -> Just (AtAngle sector w epsilon)
{-# INLINE sectorOf #-}

-- | The result of looking up a ray.
data Found
  = -- | The light comes from the hole.
    FromHole
  | -- | On this patch, at these arguments.
    OnPatch Patch {-# UNPACK #-} !Double {-# UNPACK #-} !Double
  | NotTabulated

find :: SkyTable -> LightRay -> Found
find table ray = case sectorOf table ray of
  Just (AtAngle (Sector edge patches) w epsilon)
    | distance < negate closest -> FromHole
    | distance > closest -> OnPatch (indexArray patches (min (rangeCount - 1) range)) x epsilon
    where
      range = truncate (x / rangeWidth)
      wc = curveValue edge epsilon
      distance = (wc - w) / wc
      x = max 0 (negate (log distance))
  _ -> NotTabulated
{-# INLINE find #-}

-- | The fate of a ray from an observer at an azimuth; 'Nothing' where the closed form is
-- needed.
tabulatedFate :: SkyTable -> Azimuth -> LightRay -> Maybe (Fate XYZ)
tabulatedFate table azimuth ray = case find table ray of
  FromHole -> Just Captured
  OnPatch known x epsilon -> case patchValue known x epsilon of
    Just direction -> Just $! Escaped (turnedBy table azimuth direction)
    Nothing -> Nothing
  NotTabulated -> Nothing

-- | @tabulatedChanges table azimuth ray neighbour neighbour@ are the first-order changes of
-- the direction of escape from a ray towards two close neighbours from the same observer;
-- 'Nothing' where the closed form is needed.
tabulatedChanges :: SkyTable -> Azimuth -> LightRay -> LightRay -> LightRay -> Maybe LensChanges
tabulatedChanges table azimuth ray neighbour1 neighbour2 = case find table ray of
  OnPatch known x epsilon
    -- The angle around the pole is no good variable beside it.
    | x > 1e-3,
      OnPatch _ x1 epsilon1 <- find table neighbour1,
      OnPatch _ x2 epsilon2 <- find table neighbour2,
      Just (Changing alongX alongEpsilon) <- patchChange known x epsilon ->
      let towards x' epsilon' =
            turnedBy
              table
              azimuth
              ((x' - x) *^ alongX ^+^ shortWay (epsilon' - epsilon) *^ alongEpsilon)
          shortWay angle = 2 * pi * turnFraction (angle / (2 * pi))
       in Just $! LensChanges (towards x1 epsilon1) (towards x2 epsilon2)
  _ -> Nothing

-- | The difference between the parameter @w@ of a ray and that of the edge of the shadow:
-- positive if the light comes from the hole, and about a quarter of the angle from the
-- edge in radians. 'Nothing' where the table does not apply.
tabulatedOffset :: SkyTable -> LightRay -> Maybe Double
tabulatedOffset table ray
  | Just (AtAngle (Sector edge _) w epsilon) <- sectorOf table ray =
    Just (w - curveValue edge epsilon)
  | otherwise = Nothing

-- | A direction for an observer at an azimuth, from that for an observer at azimuth 0.
turnedBy :: SkyTable -> Azimuth -> XYZ -> XYZ
turnedBy (SkyTable hole place _ _ _) azimuth (XYZ x y z) = XYZ (x * c + z * s) y (z * c - x * s)
  where
    phi = case azimuth of
      BoyerLindquist start -> start
      Ingoing start -> start - ingoingLead hole (placeRadius place)
    c = cos phi
    s = sin phi
