{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE CPP #-}

-- Following three rays at once needs more numbers than the processor has registers.
-- GHC's graph-colouring register allocator makes the loop an eighth faster. It counts
-- as experimental, so only versions of GHC with which all tests have passed use it.
#if __GLASGOW_HASKELL__ == 900 || __GLASGOW_HASKELL__ == 906
{-# OPTIONS_GHC -fregs-graph #-}
#endif

-- | Light followed step by step ("BlackHole.Spacetime.Schwarzschild.LeapfrogStep"), one
-- photon at a time or three.
module BlackHole.Spacetime.Schwarzschild.Leapfrog
  ( followLeapfrog,
    followThree,
  )
where

import BlackHole.Spacetime.Fate (Fate (..))
import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.March (enclosingRadius)
import BlackHole.Spacetime.Momentum
import BlackHole.Spacetime.PathPlane
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Schwarzschild.StepRule
import BlackHole.Spacetime.Types (Spacetime, pullOfGravity)
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^))
import qualified BlackHole.Vector.XYZ as XYZ

-- | Follows a photon of unit energy ('withUnitEnergy') step by step until it is
-- captured (moving inward at @r ≤ 1@), escapes (moving outward beyond the celestial
-- sphere), is hidden, or runs out of steps. Only path segments whose middle lies in the
-- region reach the caller. Linear in the number of steps, which the limit bounds;
-- allocates nothing per step.
followLeapfrog ::
  Leapfrog ->
  Spacetime ->
  Region ->
  Photon ->
  (a -> PathSegment -> Continue a) ->
  a ->
  Followed a
followLeapfrog leapfrog spacetime region photon gather =
  followAlone leapfrog region (orbitalPlane spacetime photon) gather 0 (startInPlane photon)

-- | Follows three photons at once, each with its own gathering function. The result is
-- bit-identical to three calls of 'followLeapfrog' and takes about half the time.
--
-- A step is a chain of roots and divisions, each of which waits for the previous one.
-- While one path waits, the processor works on the others. As soon as one path ends,
-- the others continue alone, which costs little because neighbouring paths end at about
-- the same time.
--
-- The function is long because its loop keeps all of its state in registers, with each
-- number of each path by name.
followThree ::
  Leapfrog ->
  Spacetime ->
  Region ->
  (Photon, a -> PathSegment -> Continue a) ->
  (Photon, a -> PathSegment -> Continue a) ->
  (Photon, a -> PathSegment -> Continue a) ->
  a ->
  (Followed a, Followed a, Followed a)
followThree leapfrog spacetime region first second third beginning =
  withStepLength rule $ \lengthAt -> begin lengthAt
  where
    !(Leapfrog rule skyRadius limit) = leapfrog
    !(photon0, gather0) = first
    !(photon1, gather1) = second
    !(photon2, gather2) = third
    InPlane a00 b00 u00 v00 = startInPlane photon0
    InPlane a10 b10 u10 v10 = startInPlane photon1
    InPlane a20 b20 u20 v20 = startInPlane photon2
    !plane0@(Plane _ _ heightA0 heightB0 pull0) = orbitalPlane spacetime photon0
    !plane1@(Plane _ _ heightA1 heightB1 pull1) = orbitalPlane spacetime photon1
    !plane2@(Plane _ _ heightA2 heightB2 pull2) = orbitalPlane spacetime photon2
    !sky2 = skyRadius * skyRadius
    -- Above this height, half a step does not reach the gas.
    !clear = tallestHeight region + longestNearGas rule region
    begin lengthAt =
      loop 0 a00 b00 u00 v00 a10 b10 u10 v10 a20 b20 u20 v20 beginning beginning beginning
      where
        loop !n !a0 !b0 !u0 !v0 !a1 !b1 !u1 !v1 !a2 !b2 !u2 !v2 s0 s1 s2
          | r0 <= 1 || r1 <= 1 || r2 <= 1 || r0 > sky2 || r1 > sky2 || r2 > sky2 || n >= limit =
            apart
          | abs h0 > clear && abs h1 > clear && abs h2 > clear = onward s0 s1 s2
          | otherwise = case meet plane0 gather0 dt0 start0 middle0 after0 s0 of
            Stop _ -> apart
            Continue s0' -> case meet plane1 gather1 dt1 start1 middle1 after1 s1 of
              Stop _ -> apart
              Continue s1' -> case meet plane2 gather2 dt2 start2 middle2 after2 s2 of
                Stop _ -> apart
                Continue s2' -> onward s0' s1' s2'
          where
            !r0 = a0 * a0 + b0 * b0
            !r1 = a1 * a1 + b1 * b1
            !r2 = a2 * a2 + b2 * b2
            !h0 = heightA0 * a0 + heightB0 * b0
            !h1 = heightA1 * a1 + heightB1 * b1
            !h2 = heightA2 * a2 + heightB2 * b2
            !dt0 = stepTime lengthAt r0 h0 u0 v0
            !dt1 = stepTime lengthAt r1 h1 u1 v1
            !dt2 = stepTime lengthAt r2 h2 u2 v2
            !ma0 = a0 + 0.5 * dt0 * u0
            !ma1 = a1 + 0.5 * dt1 * u1
            !ma2 = a2 + 0.5 * dt2 * u2
            !mb0 = b0 + 0.5 * dt0 * v0
            !mb1 = b1 + 0.5 * dt1 * v1
            !mb2 = b2 + 0.5 * dt2 * v2
            !kick0 = kickAt pull0 dt0 ma0 mb0
            !kick1 = kickAt pull1 dt1 ma1 mb1
            !kick2 = kickAt pull2 dt2 ma2 mb2
            !u0' = u0 + kick0 * ma0
            !u1' = u1 + kick1 * ma1
            !u2' = u2 + kick2 * ma2
            !v0' = v0 + kick0 * mb0
            !v1' = v1 + kick1 * mb1
            !v2' = v2 + kick2 * mb2
            start0 = InPlane a0 b0 u0 v0
            start1 = InPlane a1 b1 u1 v1
            start2 = InPlane a2 b2 u2 v2
            middle0 = XY ma0 mb0
            middle1 = XY ma1 mb1
            middle2 = XY ma2 mb2
            after0 = XY u0' v0'
            after1 = XY u1' v1'
            after2 = XY u2' v2'
            onward =
              loop
                (n + 1)
                (ma0 + 0.5 * dt0 * u0')
                (mb0 + 0.5 * dt0 * v0')
                u0'
                v0'
                (ma1 + 0.5 * dt1 * u1')
                (mb1 + 0.5 * dt1 * v1')
                u1'
                v1'
                (ma2 + 0.5 * dt2 * u2')
                (mb2 + 0.5 * dt2 * v2')
                u2'
                v2'
            apart =
              ( followAlone leapfrog region plane0 gather0 n start0 s0,
                followAlone leapfrog region plane1 gather1 n start1 s1,
                followAlone leapfrog region plane2 gather2 n start2 s2
              )
    {-# INLINE begin #-}
    meet plane gather dt start middle after state
      | insideRegion region place = gather state (segmentInPlane plane dt place start middle after)
      | otherwise = Continue state
      where
        place = placeInSpace plane middle

-- | The plane of a path: its two unit vectors, their heights above the disk's plane, and
-- @−(3\/2) h²@. The vectors are pointers, so that the loop carries two words and not six.
data Plane
  = Plane
      !XYZ
      !XYZ
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double

orbitalPlane :: Spacetime -> Photon -> Plane
orbitalPlane spacetime photon =
  Plane
    e1
    e2
    height1
    height2
    (negate (pullOfGravity spacetime * XYZ.normSquared (angularMomentum photon)))
  where
    Launch (PathPlane e1@(XYZ _ height1 _) e2@(XYZ _ height2 _)) _ _ =
      launch (XYZ.norm (photonPosition photon)) photon

placeInSpace :: Plane -> XY -> XYZ
placeInSpace (Plane e1 e2 _ _ _) (XY a b) = a *^ e1 ^+^ b *^ e2
{-# INLINE placeInSpace #-}

-- | Position and velocity in the plane's own coordinates.
data InPlane
  = InPlane
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double
      {-# UNPACK #-} !Double

startInPlane :: Photon -> InPlane
startInPlane photon = InPlane r 0 radial tangential
  where
    r = XYZ.norm (photonPosition photon)
    Launch _ radial tangential = launch r photon

segmentInPlane :: Plane -> Double -> XYZ -> InPlane -> XY -> XY -> PathSegment
segmentInPlane
  (Plane (XYZ x1 _ z1) (XYZ x2 _ z2) heightA heightB _)
  dt
  place
  (InPlane _ _ u0 v0)
  (XY a b)
  (XY u1 v1) =
    PathSegment
      { segmentMiddle = place,
        segmentRadius = r,
        segmentAffineLength = dt,
        segmentLength = dt * sqrt (u * u + v * v),
        segmentRadialStep = dt * radial / r,
        segmentVerticalStep = dt * (heightA * u + heightB * v),
        segmentMomentum = Momentum (negate radial / (r - 1)) ((a * v - b * u) * (x1 * z2 - z1 * x2))
      }
    where
      u = 0.5 * (u0 + u1)
      v = 0.5 * (v0 + v1)
      r = sqrt (a * a + b * b)
      radial = a * u + b * v
{-# INLINE segmentInPlane #-}

-- | The pseudo-time of a step, from the rule, the squared distance to the hole, the
-- height and the velocity. Written so that root and division do not wait for each
-- other.
stepTime :: (Double -> Double -> Double) -> Double -> Double -> Double -> Double -> Double
stepTime lengthAt r2 y u v = lengthAt r2 y * (sqrt v2 * (1 / v2))
  where
    v2 = u * u + v * v
{-# INLINE stepTime #-}

-- | The change of velocity in the middle of a step, divided by the position there.
kickAt :: Double -> Double -> Double -> Double -> Double
kickAt pull dt a b = pull * dt * (sqrt r2 * (1 / (r2 * r2 * r2)))
  where
    r2 = a * a + b * b
{-# INLINE kickAt #-}

-- | An upper bound on half of any step that starts within reach of the gas.
longestNearGas :: StepRule -> Region -> Double
longestNearGas (EqualSteps l) _ = l
longestNearGas (ReportSteps l0 _) region
  -- Steps beyond r = 40 have the length 10.
  | enclosingRadius region < 30 = l0
  | otherwise = 10

-- | The greatest height of the gas.
tallestHeight :: Region -> Double
tallestHeight region
  -- Without a flare the radius may be infinite.
  | regionFlare region == 0 = regionHalfHeight region
  | otherwise = halfHeightAt region (regionRadius region)

followAlone ::
  Leapfrog ->
  Region ->
  Plane ->
  (a -> PathSegment -> Continue a) ->
  Int ->
  InPlane ->
  a ->
  Followed a
followAlone
  (Leapfrog rule skyRadius limit)
  region
  plane@(Plane _ _ heightA heightB pull)
  gather
  first
  (InPlane a0 b0 u0 v0)
  state0 =
    withStepLength rule $ \lengthAt -> begin lengthAt
    where
      !sky2 = skyRadius * skyRadius
      !tallest = tallestHeight region
      begin lengthAt = go first a0 b0 u0 v0 state0
        where
          go !n !a !b !u !v !state
            | r2 <= 1 && a * u + b * v < 0 = Followed Captured state n
            | r2 > sky2 && a * u + b * v > 0 = escaped
            | n >= limit = Followed StepLimit state n
            | abs y <= tallest && insideRegion region place =
              case gather
                state
                (segmentInPlane plane dt place (InPlane a b u v) (XY ma mb) (XY u' v')) of
                Continue state' -> go (n + 1) a' b' u' v' state'
                Stop state' -> Followed Opaque state' (n + 1)
            | otherwise = go (n + 1) a' b' u' v' state
            where
              !r2 = a * a + b * b
              !dt = stepTime lengthAt r2 (heightA * a + heightB * b) u v
              !ma = a + 0.5 * dt * u
              !mb = b + 0.5 * dt * v
              !kick = kickAt pull dt ma mb
              !u' = u + kick * ma
              !v' = v + kick * mb
              !a' = ma + 0.5 * dt * u'
              !b' = mb + 0.5 * dt * v'
              !y = heightA * ma + heightB * mb
              place = placeInSpace plane (XY ma mb)
              escaped = case XYZ.normalize (placeInSpace plane (XY u v)) of
                Just direction -> Followed (Escaped direction) state n
                -- Reached only by a photon that never had a direction.
                Nothing -> Followed StepLimit state n
      {-# INLINE begin #-}
