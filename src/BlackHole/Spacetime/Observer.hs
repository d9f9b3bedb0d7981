{-# LANGUAGE BangPatterns #-}

-- | Observers: how the directions they see become light paths, and how their motion and
-- position shift the frequency of light.
--
-- Directions refer to the observer's own orthonormal frame, written in the Cartesian
-- components of pseudo-space: the radial unit vector is @x/r@, and the azimuthal one is
-- that of the right-handed rotation about @+y@. Formulas: Misner, Thorne and Wheeler
-- 1973, /Gravitation/, §25 and box 31.2.
module BlackHole.Spacetime.Observer
  ( Observer (..),
    observerName,
    observerRange,
    observerExists,
    kerrMotion,
    frequencyAtRest,
    SightLine (..),
    sightFrequency,
    sightPhoton,
    kerrPlace,
    Constants (..),
    sightConstants,
    Eye,
    eye,
    eyePlace,
    sightFrom,
    sightLine,
  )
where

import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Kerr.Sight
import BlackHole.Spacetime.Momentum (staticFrequency)
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Types (Spacetime (..))
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Maybe (fromMaybe, isJust)
import GHC.Exts (lazy)

-- | The motion of the observer.
data Observer
  = -- | At rest, hovering on rockets.
    Static
  | -- | Without angular momentum about the axis, turning with space around a rotating
    -- hole; at rest around any other.
    Zamo
  | -- | On the circular geodesic through the observer's position, right-handed about
    -- the axis through the hole that lies closest to @+y@; around a rotating hole off the
    -- plane, on the spherical geodesic that turns back in latitude there.
    Orbiting
  | -- | 'Orbiting', but left-handed.
    CounterOrbiting
  | -- | Falling straight in from rest at infinity.
    Falling
  | -- | The camera of the design report (Will Yager, "Accurately Rendering a Black
    -- Hole"), which corresponds to no physical observer. It interprets directions as
    -- coordinate directions, which makes the hole appear too large, and it does not
    -- shift light.
    Coordinate
  deriving (Eq, Show, Read, Enum, Bounded)

-- | The observer's name on the command line.
observerName :: Observer -> String
observerName observer = case observer of
  Static -> "static"
  Zamo -> "zamo"
  Orbiting -> "orbiting"
  CounterOrbiting -> "counter-orbiting"
  Falling -> "falling"
  Coordinate -> "coordinate"

-- | The radius above which such an observer can exist, at a position of this polar angle
-- in radians.
observerRange :: Spacetime -> Observer -> Double -> Double
observerRange space observer polarAngle = case space of
  Flat -> 1
  Schwarzschild -> case observer of
    Static -> 1
    Zamo -> 1
    Orbiting -> 1.5
    CounterOrbiting -> 1.5
    Falling -> 0
    Coordinate -> 1
  Kerr hole -> case observer of
    Static -> ergosphereRadius hole (cos polarAngle)
    Zamo -> horizonRadius hole
    Orbiting -> leastOrbit (horizonRadius hole) 10
    CounterOrbiting -> leastOrbit (horizonRadius hole) 10
    Falling -> 0
    Coordinate -> 1
  where
    -- By bisection, to rounding: far out there is an orbit, at the horizon none.
    leastOrbit :: Double -> Double -> Double
    leastOrbit low high
      | middle <= low || middle >= high = high
      | observerExists space observer (XYZ (middle * sin polarAngle) (middle * cos polarAngle) 0) =
        leastOrbit low middle
      | otherwise = leastOrbit middle high
      where
        middle = 0.5 * (low + high)

-- | Whether such an observer can exist at a position.
observerExists :: Spacetime -> Observer -> XYZ -> Bool
observerExists space observer place = case space of
  Kerr hole
    | Just motion <- kerrMotion observer,
      motion /= InFreeFall ->
      -- A direction against which no observer's motion turns the energy negative.
      isJust
        (lightRay hole (kerrPlace place) motion (Direction 0 0 (negate (signum (spinLength hole)))))
  _ -> r > observerRange space observer (placePolarAngle (kerrPlace place))
  where
    r = XYZ.norm place

-- | The frequency that an observer at rest at a position measures over that at infinity.
-- 'Nothing' where none can be, at and inside the horizon and in the ergosphere.
frequencyAtRest :: Spacetime -> XYZ -> Maybe Double
frequencyAtRest space place = case space of
  Flat -> Just 1
  Schwarzschild -> staticFrequency (XYZ.norm place)
  Kerr hole -> rayObserved <$> lightRay hole (kerrPlace place) AtRest (Direction 1 0 0)

-- | The observer's motion around a rotating hole; 'Nothing' for the camera of the design
-- report, which is defined without spin only.
kerrMotion :: Observer -> Maybe Motion
kerrMotion observer = case observer of
  Static -> Just AtRest
  Zamo -> Just ZeroAngularMomentum
  Orbiting -> Just (OnOrbit RightHanded)
  CounterOrbiting -> Just (OnOrbit LeftHanded)
  Falling -> Just InFreeFall
  Coordinate -> Nothing

-- | A position in the coordinates of a rotating hole.
kerrPlace :: XYZ -> Place
kerrPlace (XYZ x y z) = Place (sqrt (rho2 + y * y)) (atan2 (sqrt rho2) y)
  where
    rho2 = x * x + z * z

-- | One line of sight, and the frequency seen by the observer over the frequency at
-- infinity, which shifts the light of the sky ('sightFrequency').
data SightLine
  = -- | The photon to follow backwards, of unit energy, on a path that lies in a plane.
    SightLine !Photon {-# UNPACK #-} !Double
  | -- | A ray around a rotating hole, from an observer at this azimuth.
    RotatingSight !Spin !Azimuth !LightRay
  deriving (Eq, Show)

-- | The frequency seen by the observer over the frequency at infinity.
sightFrequency :: SightLine -> Double
sightFrequency (SightLine _ observed) = observed
sightFrequency (RotatingSight _ _ ray) = rayObserved ray
{-# INLINE sightFrequency #-}

-- | The photon to follow backwards, on a path that lies in a plane.
sightPhoton :: SightLine -> Maybe Photon
sightPhoton (SightLine photon _) = Just photon
sightPhoton RotatingSight {} = Nothing

-- | What does not change along a light path, for unit energy at infinity.
data Constants
  = -- | @x × v@. Its length is the impact parameter in Schwarzschild radii.
    AngularMomentum !XYZ
  | -- | Around a rotating hole: the angular momentum λ about the axis, in Schwarzschild
    -- radii, and Carter's constant, in their squares.
    LambdaAndCarter !Double !Double
  deriving (Eq, Show)

-- | The constants of the light path that a line of sight follows.
sightConstants :: SightLine -> Constants
sightConstants (SightLine photon _) = AngularMomentum (angularMomentum photon)
sightConstants (RotatingSight _ _ ray) = LambdaAndCarter (rayLambda ray) (rayEta ray)

-- | An observer at a position, prepared with everything that all lines of sight share.
data Eye = Eye
  { _eyeKind :: !EyeKind,
    -- | The observer's position.
    eyePlace :: {-# UNPACK #-} !XYZ,
    -- | Unit vector away from the hole.
    _eyeRadial :: {-# UNPACK #-} !XYZ,
    -- | √(1 − 1/r).
    _eyeDilation :: {-# UNPACK #-} !Double,
    -- | √(1/r), the speed of an observer who falls in from rest at infinity.
    _eyeInfall :: {-# UNPACK #-} !Double,
    -- | The direction of circular motion, and its speed relative to the static
    -- observer.
    _eyeAzimuthal :: {-# UNPACK #-} !XYZ,
    _eyeSpeed :: {-# UNPACK #-} !Double
  }

-- | How directions become paths.
data EyeKind
  = -- | No such observer can exist there.
    Nobody
  | -- | Space without gravity.
    InFlatSpace
  | Near !Observer
  | NearRotating !Rotating

-- | An observer near a rotating hole: motion and position, with the unit vectors of
-- increasing polar angle and azimuth.
data Rotating = Rotating !Spin !Seer !Azimuth !XYZ !XYZ

-- | Prepares an observer at a position for 'sightFrom'.
eye :: Spacetime -> Observer -> XYZ -> Eye
eye space observer place =
  Eye
    kind
    place
    radial
    (sqrt (1 - 1 / r))
    (sqrt (1 / r))
    (orbitDirection radial)
    (sqrt (1 / (2 * (r - 1))))
  where
    r = XYZ.norm place
    radial = (1 / r) *^ place
    kind = case space of
      Flat -> InFlatSpace
      Schwarzschild
        | r <= observerRange Schwarzschild observer 0 || isNaN r -> Nobody
        | otherwise -> Near observer
      Kerr hole -> case kerrMotion observer of
        Just motion
          | observerExists space observer place ->
            NearRotating (rotating hole motion place)
        _ -> Nobody

rotating :: Spin -> Motion -> XYZ -> Rotating
rotating hole motion place@(XYZ x _ z) =
  Rotating
    hole
    (seer hole there motion)
    (if motion == InFreeFall then Ingoing phi else BoyerLindquist phi)
    (XYZ (cos theta * sin phi) (negate (sin theta)) (cos theta * cos phi))
    (XYZ (cos phi) 0 (negate (sin phi)))
  where
    there@(Place _ theta) = kerrPlace place
    phi = atan2 x z

-- | @sightLine space observer place = 'sightFrom' ('eye' space observer place)@.
sightLine :: Spacetime -> Observer -> XYZ -> XYZ -> Maybe SightLine
sightLine space observer place = sightFrom (eye space observer place)

-- | The light path that the observer sees in a direction (of unit length, pointing away
-- from the observer). 'Nothing' if no light from outside arrives along it, which
-- happens inside the horizon, or if no such observer exists ('observerRange').
sightFrom :: Eye -> XYZ -> Maybe SightLine
sightFrom prepared !direction = case kind of
  Nobody -> Nothing
  InFlatSpace -> XYZ.normalize direction >>= \d -> along (Photon place d) 1
  Near Coordinate -> withUnitEnergy (Photon place direction) >>= \photon -> along photon 1
  Near Static -> static direction
  Near Zamo -> static direction
  Near Orbiting -> orbiting azimuthal
  Near CounterOrbiting -> orbiting (XYZ.negated azimuthal)
  NearRotating (Rotating hole rotator azimuth southward eastward) ->
    RotatingSight hole azimuth
      <$> raySeen
        rotator
        ( Direction
            (XYZ.dot radial direction)
            (XYZ.dot southward direction)
            (XYZ.dot eastward direction)
        )
  Near Falling ->
    fromEnergy (1 + infall * XYZ.dot radial direction) (direction ^+^ infall *^ radial)
  where
    -- Makes GHC pass the components of the direction one by one instead of those of the
    -- prepared observer, so that no direction is allocated.
    Eye kind place radial dilation infall azimuthal speed = lazy prepared
    gamma = 1 / sqrt (1 - speed * speed)
    orbiting forward =
      -- The light moves along −direction, so the momentum to boost back into the static
      -- frame is −direction. Its reverse is the direction seen there.
      let forwards = XYZ.dot forward direction
          -- Frequency in the static frame of light that has frequency one here.
          frequency = gamma * (1 - speed * forwards)
          momentum = direction ^+^ ((gamma - 1) * forwards - gamma * speed) *^ forward
       in static ((1 / frequency) *^ momentum) >>= slowed frequency
    slowed frequency sight = case sight of
      SightLine photon shift -> along photon (shift / frequency)
      RotatingSight {} -> Nothing
    along photon shift = Just $! SightLine photon shift
    -- Light of frequency one for the observer has this energy at infinity and this
    -- pseudo-velocity. Scale both to unit energy.
    fromEnergy energy velocity
      | energy > 0 = along (Photon place ((1 / energy) *^ velocity)) (1 / energy)
      | otherwise = Nothing
    -- The static observer's radial unit of length is shorter than the coordinate's, so
    -- only the radial component of a direction changes.
    static d = fromEnergy dilation (d ^-^ ((1 - dilation) * XYZ.dot radial d) *^ radial)

-- | The direction of circular motion: right-handed about @+y@. Over the poles, where it
-- is undefined, @+x@.
orbitDirection :: XYZ -> XYZ
orbitDirection radial =
  fromMaybe (XYZ 1 0 0) (XYZ.normalize (XYZ.cross (XYZ 0 1 0) radial))
