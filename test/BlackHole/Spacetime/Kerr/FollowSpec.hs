module BlackHole.Spacetime.Kerr.FollowSpec (spec) where

import BlackHole.Spacetime.Follow
import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Kerr.Path
import BlackHole.Spacetime.Kerr.Sight
import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.Momentum
import BlackHole.Spacetime.Observer (Observer (Static), SightLine (..), sightLine)
import BlackHole.Spacetime.Types (Spacetime (..))
import BlackHole.Vector.XYZ (XYZ (..), (*^))
import qualified BlackHole.Vector.XYZ as XYZ
import Support.Approx
import Support.KerrReference
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck

spec :: Spec
spec = do
  modifyMaxSuccess (const 100) . prop "segments lie on the path, with the photon's momentum" $
    forAll sights $ \(hole, at, ray, offset) ->
      let azimuth = BoyerLindquist 0.7
          found = timed hole ByTable (RotatingSight hole azimuth ray) everywhere at
          path = kerrPath hole azimuth ray
          a = spinLength hole
       in counterexample (show (kerrMinoTime path)) . (null found === False .&&.) $
            conjoin
              [ counterexample (show (t, segment)) $
                  nearXYZ
                    (1e-4 * (1 + stretched) * wound * max 1 (r / 20))
                    (1 / r *^ placed point)
                    (1 / r *^ segmentMiddle segment)
                    .&&. closeTo
                      (1e-4 * (1 + radial') * (1 + stretched) * wound)
                      (radial' * signum' (pointGrows point))
                      radial
                    .&&. lambda === rayLambda ray
                | (t, segment) <- found,
                  t < 0.999 * kerrMinoTime path,
                  let point = kerrPoint path t
                      r = pointRadius point,
                  r > 1.05 * horizonRadius hole,
                  let p = r * r + a * (a - rayLambda ray)
                      -- Beside the horizon the momentum grows without limit.
                      stretched = 1e-2 / kerrDelta hole r
                      -- A path that leaves a photon orbit multiplies the errors made before,
                      -- and far from the hole an error of 1/r grows with r.
                      wound = 1 + 1e-2 / abs offset
                      delta = kerrDelta hole r
                      radial' = sqrt (max 0 (p * p - delta * rayKappa ray)) / delta
                      Momentum radial lambda = segmentMomentum segment
                      signum' grows = if grows then -1 else 1
              ]
  prop "no point of a path near the plane and within a radius is outside all passages" $
    forAll sights $ \(hole, _, ray, _) -> forAll ((,) <$> choose (3, 30) <*> choose (0.05, 0.9)) $
      \(limit, steepest) ->
        let path = kerrPath hole (BoyerLindquist 0) ray
            time = kerrMinoTime path
            passages = kerrPassages path limit steepest
            inOne t = any (\(from, to) -> t >= from - 1e-9 && t <= to + 1e-9) passages
         in conjoin
              [ counterexample (show (t, point, passages)) (inOne t)
                | k <- [1 .. 399 :: Int],
                  let t = time * fromIntegral k / 400
                      point = kerrPoint path t,
                  pointRadius point < 0.999 * limit,
                  abs (pointCosine point) < 0.999 * steepest,
                  pointRadius point > 1.001 * horizonRadius hole
              ]
  it "has errors that fall as the fourth power of the step" $
    [worstError 0.16 / worstError 0.08, worstError 0.08 / worstError 0.04]
      `shouldSatisfy` all (> 12)
  it "comes to an end with light that leaves a photon orbit before the closed form's time" $ do
    -- An observer on a circular orbit between both photon orbits, in the plane.
    let hole = spinOf 0.9
        circling =
          LightRay
            { rayRadius = 1.5,
              rayCosine = 0,
              raySine = 1,
              rayRadialRate = -1.5436164188402408,
              rayPolarRate = 6.851102968110938e-2,
              rayLambda = 1.421537577829341,
              rayEta = 4.69376118796585e-3,
              rayKappa = 0.9485790263224689,
              rayObserved = 1.063695164997064
            }
        sight = RotatingSight hole (BoyerLindquist 0.7) circling
        region = Region 11 0 0 6.1465831788796096e-2 0.18931434420911386 0.05 0.47328586052278465
        count n _ = Continue (n + 1 :: Int)
        phase = 0.9998651912046661
        followed = follow (tracing (Kerr hole) ByTable (XYZ 1.5 0 0)) region phase sight count 0
    -- Where it does not, this test does not end either.
    followedState followed `shouldSatisfy` \n -> n > 100 && n < 10000
  it "gathers as much in a layer of gas by table as in closed form, at a tiny spin as at none" $
    sequence_
      [ gathered space method psi eta `shouldBeWithin` (0.02 * expected + 1e-3, expected)
        | (psi, eta) <- [(0.2, 0.5), (0.3, -1.2), (0.09, 2), (0.5, 3)],
          (space, method, expected) <-
            [ (Kerr (spinOf 0.9), ByTable, gathered (Kerr (spinOf 0.9)) InClosedForm psi eta),
              (Kerr (spinOf 1e-6), ByTable, gathered Schwarzschild ByTable psi eta)
            ]
      ]
  where
    -- One passage from the observer to the end, on which the steps' errors add up; a
    -- passage through a disk is much shorter.
    everywhere = Region 200 0 200 0 0.02 0.02 1
    -- The greatest error of a segment's place, over the radius, on a path that passes the
    -- hole at some distance, with segments of this length over the radius.
    worstError step = case lightRay hole at ZeroAngularMomentum (aimed 0.35 0.6) of
      Just ray ->
        maximum
          [ XYZ.distance (placed (kerrPoint path t)) (segmentMiddle segment)
              / segmentRadius segment
            | (t, segment) <- timed hole InClosedForm (RotatingSight hole azimuth ray) region at
          ]
        where
          path = kerrPath hole azimuth ray
      Nothing -> 0 / 0
      where
        hole = spinOf 0.9
        at = Place 20 1.1
        azimuth = BoyerLindquist 0.7
        region = Region 20 0 20 0 step step 1
    -- The segments of a line of sight with the Mino times of their middles.
    timed hole method sight region at =
      snd (followedState (follow traced region 1 sight gather (0, [])))
      where
        traced = tracing (Kerr hole) method (position at)
        a = spinLength hole
        gather (begun, others) segment =
          Continue (begun + duration, (begun + 0.5 * duration, segment) : others)
          where
            XYZ _ y _ = segmentMiddle segment
            r = segmentRadius segment
            duration = segmentAffineLength segment / (r * r + a * a * y * y / (r * r))
    position (Place r theta) = XYZ (r * sin theta) (r * cos theta) 0
    placed point =
      let s = sqrt (1 - pointCosine point * pointCosine point)
          r = pointRadius point
          phi = pointAzimuth point
       in XYZ (r * s * sin phi) (r * pointCosine point) (r * s * cos phi)
    sights = do
      s <- oneof [choose (-0.99, 0.99), choose (-0.05, 0.05)]
      r <- exp <$> choose (log 2, log 40)
      theta <- choose (0.1, pi - 0.1)
      psi <- oneof [choose (0, pi), (\x -> x * 4 / (r + 3)) <$> choose (0, 1)]
      eta <- choose (-pi, pi)
      let hole = spinOf s
          at = Place r theta
          offsetOf =
            shadowOffset (tracing (Kerr hole) InClosedForm (position at))
              . RotatingSight hole (BoyerLindquist 0)
      case lightRay hole at ZeroAngularMomentum (aimed psi eta) of
        Just ray
          | Just offset <- offsetOf ray, abs offset > 1e-3 -> pure (hole, at, ray, offset)
        _ -> sights
    gathered space method psi eta =
      let at = XYZ (20 * sin 1.2) (20 * cos 1.2) 0
          slab = Region 12 1.6 0.5 0 0.01 0.01 1
          Direction nr ntheta nphi = aimed psi eta
          direction =
            XYZ
              (nr * sin 1.2 + ntheta * cos 1.2)
              (nr * cos 1.2 - ntheta * sin 1.2)
              (negate nphi)
          gather sofar segment = Continue (sofar + segmentAffineLength segment)
       in case sightLine space Static at direction of
            Just sight -> followedState (follow (tracing space method at) slab 1 sight gather 0)
            Nothing -> 0 / 0
