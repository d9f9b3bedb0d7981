-- | Light followed through any of the spacetimes: its segments, its end, its crossings of
-- the disk's plane, and how neighbouring rays differ.
--
-- Everything that shines or absorbs sees path segments alone
-- ("BlackHole.Spacetime.LightPath"). Another stationary, axisymmetric spacetime would be
-- another alternative of the functions below.
module BlackHole.Spacetime.Follow
  ( Tracing (..),
    Method (..),
    tracing,
    tracingTables,
    tracingServes,
    follow,
    pathFate,
    rotatingPath,
    planeCrossings,
    pathDeflection,
    skyJacobian,
    shadowOffset,
  )
where

import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Kerr.Follow
import BlackHole.Spacetime.Kerr.Landmarks (Spin, horizonRadius, kerrDelta)
import BlackHole.Spacetime.Kerr.Path
import BlackHole.Spacetime.Kerr.RadialPotential (photonOrbitOffset, radialPotential)
import BlackHole.Spacetime.Kerr.Sight
import BlackHole.Spacetime.Kerr.SkyTable
import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.Momentum
import BlackHole.Spacetime.Observer (SightLine (..), kerrPlace)
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.PlaneCrossing
import BlackHole.Spacetime.Schwarzschild.ExactPath
import BlackHole.Spacetime.Schwarzschild.Leapfrog
import BlackHole.Spacetime.Schwarzschild.LensDifferential
import BlackHole.Spacetime.Schwarzschild.LensTable
import BlackHole.Spacetime.Schwarzschild.StepRule
import BlackHole.Spacetime.Schwarzschild.TablePath
import BlackHole.Spacetime.Schwarzschild.Trajectory
import BlackHole.Spacetime.Schwarzschild.TrajectoryPoints
import BlackHole.Spacetime.Types (Spacetime (..))
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Maybe (fromMaybe)

-- | A spacetime, and how to follow light to a camera in it.
data Tracing = Tracing
  { tracingSpacetime :: !Spacetime,
    tracingMethod :: !Method,
    -- | The paths through the camera's position around a hole without spin, computed at
    -- their first use.
    tracingTable :: LensTable,
    -- | The directions from which light comes to the camera around a rotating hole,
    -- computed as far as rays need them.
    tracingSkyTable :: Maybe SkyTable,
    -- | The camera's position.
    _tracingPlace :: !XYZ
  }

-- | The ways to follow light. Around a rotating hole the table holds where a path ends,
-- and the closed form serves for everything else.
data Method = ByTable | InClosedForm | ByLeapfrog !Leapfrog

-- | @tracing space method place@ is for a camera at a position.
tracing :: Spacetime -> Method -> XYZ -> Tracing
tracing space method place = Tracing space method (lensTable (XYZ.norm place)) rotating place
  where
    rotating = case (space, method) of
      (Kerr hole, ByTable) -> Just (skyTable hole (kerrPlace place))
      _ -> Nothing

-- | Whether the tables of a camera serve for one at another position, to rounding.
tracingServes :: Tracing -> XYZ -> Bool
tracingServes (Tracing space _ _ _ before@(XYZ _ height _)) place@(XYZ _ height' _) = case space of
  Kerr _ -> sameDistance && abs (height' - height) <= 1e-12 * XYZ.norm before
  _ -> sameDistance
  where
    sameDistance = abs (XYZ.norm place - XYZ.norm before) <= 1e-12 * XYZ.norm place

-- | The table that light is followed by, if any, for evaluation in advance.
tracingTables :: Tracing -> [()]
tracingTables traced = case (tracingMethod traced, tracingSpacetime traced) of
  (ByTable, Schwarzschild) -> [seq (lensTableSize (tracingTable traced)) ()]
  _ -> []

-- | @follow tracing region phase sight gather state@ follows a line of sight to its end
-- and passes the segments inside the region to the gathering function. The phase, 0 to
-- 1, is the length of the first segment in the gas as a fraction of a whole step; give
-- neighbours in a picture different ones.
--
-- Inlined, so that GHC compiles each gathering function into the loop along the path.
follow ::
  Tracing -> Region -> Double -> SightLine -> (a -> PathSegment -> Continue a) -> a -> Followed a
follow traced@(Tracing space method table _ _) region phase sight gather initial = case sight of
  RotatingSight hole azimuth ray ->
    let path = rotatingPath traced hole azimuth ray
     in followKerr hole region phase path (rotatingFate traced path azimuth ray) ray gather initial
  SightLine photon _ -> case method of
    ByTable -> followTable space table region phase photon gather initial
    InClosedForm -> followExact space region photon gather initial
    ByLeapfrog leapfrog -> followLeapfrog leapfrog space region photon gather initial
{-# INLINE follow #-}

-- | The fate of a line of sight with nothing in its way.
pathFate :: Tracing -> SightLine -> Fate XYZ
pathFate traced sight = case (sight, tracingMethod traced) of
  (RotatingSight hole azimuth ray, _) -> rotatingFate traced (kerrPath hole azimuth ray) azimuth ray
  (SightLine photon _, ByTable) -> tableFate (tracingSpacetime traced) (tracingTable traced) photon
  _ -> followedFate (follow traced emptyRegion 0 sight (\() _ -> Continue ()) ())

-- | The closed form of a path around a rotating hole, as exact as the method asks for.
rotatingPath :: Tracing -> Spin -> Azimuth -> LightRay -> KerrPath
rotatingPath traced = kerrPathWith $ case tracingMethod traced of
  ByTable -> PicturePrecision
  _ -> FullPrecision
{-# INLINE rotatingPath #-}

-- | The end of a path around a rotating hole, from the table where it applies.
rotatingFate :: Tracing -> KerrPath -> Azimuth -> LightRay -> Fate XYZ
rotatingFate traced path azimuth ray =
  fromMaybe (kerrFate path) $
    tracingSkyTable traced >>= \table -> tabulatedFate table azimuth ray

-- | All crossings of the disk's plane along a line of sight, in order from the camera,
-- whether or not gas hides them, with the momentum of the real photon there; 'Nothing' at
-- and inside the horizon. The camera's own position does not count. Empty for a path that
-- lies in the plane.
--
-- The leapfrog's crossings are interpolated between its steps, with an error of the order
-- of the leapfrog's own.
planeCrossings :: Tracing -> SightLine -> [PlaneCrossing (Maybe Momentum)]
planeCrossings traced sight = case sight of
  RotatingSight hole azimuth ray ->
    map (rotatingCrossing hole ray) (kerrPlanePoints (rotatingPath traced hole azimuth ray))
  SightLine photon observed ->
    maybe
      (leapfrogCrossings traced sight photon)
      trajectoryCrossings
      (planarTrajectory traced observed photon)

rotatingCrossing :: Spin -> LightRay -> KerrPoint -> PlaneCrossing (Maybe Momentum)
rotatingCrossing hole ray (KerrPoint r _ azimuth grows _) =
  PlaneCrossing r (wrappedAngle (0.5 * pi - azimuth)) momentum
  where
    radial = sqrt (max 0 (radialPotential hole ray r)) / kerrDelta hole r
    momentum
      | r > horizonRadius hole =
        Just (Momentum (if grows then negate radial else radial) (rayLambda ray))
      | otherwise = Nothing

-- | The whole path of a photon, unless it is followed step by step.
planarTrajectory :: Tracing -> Double -> Photon -> Maybe Trajectory
planarTrajectory (Tracing space method table _ _) observed photon = case (method, space) of
  (ByLeapfrog _, _) -> Nothing
  (_, Flat) -> Just (trajectoryOnLine observed photon)
  (ByTable, _) -> Just (trajectoryOnTable table observed photon)
  (InClosedForm, _) -> Just (trajectoryFromPhoton observed photon)

-- | Crossings interpolated between the middles of steps on either side of the plane.
leapfrogCrossings :: Tracing -> SightLine -> Photon -> [PlaneCrossing (Maybe Momentum)]
leapfrogCrossings traced sight (Photon start velocity) =
  reverse
    ( snd
        ( followedState
            ( follow
                traced
                everywhere
                0
                sight
                gather
                (Along start (XYZ.dot start velocity / XYZ.norm start), [])
            )
        )
    )
  where
    everywhere = Region (1 / 0) 0 (1 / 0) 0 1 1 1
    gather (before@(Along (XYZ _ y0 _) _), found) segment =
      Continue
        ( here,
          [between (y0 / (y0 - y1)) before here | y0 * y1 < 0 || (y1 == 0 && y0 /= 0)] ++ found
        )
      where
        here =
          Along (segmentMiddle segment) (segmentRadialStep segment / segmentAffineLength segment)
        XYZ _ y1 _ = segmentMiddle segment
        between t (Along place0 speed0) (Along place1 speed1) =
          PlaneCrossing r (planeAzimuth place) momentum
          where
            place = XYZ.lerp t place0 place1
            r = XYZ.norm place
            speed = speed0 + t * (speed1 - speed0)
            -- The light itself travels the other way.
            momentum
              | r > 1 =
                Just
                  ( Momentum
                      (negate speed * r / (r - 1))
                      (momentumAzimuthal (segmentMomentum segment))
                  )
              | otherwise = Nothing

-- | A place on a path, and dr/dl there, backwards in time.
data Along = Along !XYZ !Double

-- | The deflection in radians of the path from the sky: the angle swept beyond that of a
-- straight line, above 2π for light that went all around the hole. Around a rotating hole
-- the angle is swept along the great circle that precesses. 'Nothing' for a path that
-- does not come from the sky, and for the leapfrog.
pathDeflection :: Tracing -> SightLine -> Maybe Double
pathDeflection traced sight = case sight of
  SightLine photon observed -> planarTrajectory traced observed photon >>= trajectoryDeflection
  RotatingSight hole azimuth ray -> case kerrPath hole azimuth ray of
    path | Escaped _ <- kerrFate path -> subtract (kerrStraightAngle ray) <$> kerrSweptAngle path
    _ -> Nothing

-- | @skyJacobian tracing beside sight direction@ are the derivatives of the direction in
-- which a line of sight escapes with respect to the two components of an offset, where
-- @beside@ is the line of sight at an offset from the same position. 'Nothing' where
-- neither a table ('lensChanges', 'tabulatedChanges') nor differences towards both sides
-- offer them.
skyJacobian :: Tracing -> (XY -> Maybe SightLine) -> SightLine -> XYZ -> Maybe LensChanges
skyJacobian traced beside sight direction = case (tracingSpacetime traced, sight) of
  (Schwarzschild, SightLine photon _)
    | Just (SightLine right _) <- beside (XY 0.01 0),
      Just (SightLine below _) <- beside (XY 0 0.01),
      Just (LensChanges alongX alongY) <-
        lensChanges (tracingTable traced) photon direction right below ->
      Just (LensChanges ((1 / 0.01) *^ alongX) ((1 / 0.01) *^ alongY))
  (_, RotatingSight _ azimuth ray)
    | Just table <- tracingSkyTable traced,
      Just (RotatingSight _ _ right) <- beside (XY 0.01 0),
      Just (RotatingSight _ _ below) <- beside (XY 0 0.01),
      Just (LensChanges alongX alongY) <- tabulatedChanges table azimuth ray right below ->
      Just (LensChanges ((1 / 0.01) *^ alongX) ((1 / 0.01) *^ alongY))
  (_, RotatingSight {})
    | Just right <- beside (XY 1e-3 0) >>= escape,
      Just below <- beside (XY 0 1e-3) >>= escape ->
      Just (LensChanges ((1 / 1e-3) *^ (right ^-^ direction)) ((1 / 1e-3) *^ (below ^-^ direction)))
  _ -> Nothing
  where
    escape neighbour = case pathFate traced neighbour of
      Escaped there -> Just there
      _ -> Nothing

-- | A smooth measure of the distance of a line of sight from the edge of the shadow, 0 on
-- it and positive inside: about a quarter of the angle in radians for an observer at rest
-- around a hole without spin, and about as large around a rotating one. 'Nothing' without
-- gravity.
shadowOffset :: Tracing -> SightLine -> Maybe Double
shadowOffset (Tracing space _ table rotating _) sight = case (space, sight) of
  (Schwarzschild, SightLine photon _) -> Just (criticalOffset table photon)
  (_, RotatingSight _ _ ray)
    | Just offset <- rotating >>= \known -> tabulatedOffset known ray -> Just offset
  (_, RotatingSight hole _ ray) ->
    (* negate (2.6 / max 2.6 (rayRadius ray))) <$> photonOrbitOffset hole ray
  _ -> Nothing
