module BlackHole.Spacetime.Kerr.PathSpec (spec) where

import BlackHole.Matter.KerrFlow
import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Kerr.Path
import BlackHole.Spacetime.Kerr.Sight
import BlackHole.Spacetime.Momentum
import qualified BlackHole.Spacetime.Schwarzschild.Orbit as Orbit
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Maybe (fromMaybe)
import Support.Approx
import Support.IndependentKerr
import Support.KerrReference
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "reference rays" $ do
    it "start with the constants of motion of 34 digits, for every observer" $ do
      rays <- (++) <$> readKerrRays <*> readKerrObservers
      length rays `shouldSatisfy` (> 30)
      sequence_
        [ do
            rayObserved ray `relatively` (1e-14, nu)
            rayLambda ray `shouldBeWithin` (1e-14 * (1 + abs lambda), lambda)
            rayEta ray `shouldBeWithin` (1e-14 * (1 + abs q), q)
          | row <- rays,
            let (nu, lambda, q) = rayConstants row
                ray = rayOf row
        ]
    it "end where they should, after the right Mino time" $ do
      rays <- (++) <$> readKerrRays <*> readKerrObservers
      sequence_
        [ do
            maybe
              (pure ())
              (\time -> kerrMinoTime path `relatively` (1e-12, time))
              (rayMinoTime row)
            case (kerrFate path, rayEscape row) of
              (Captured, Nothing) -> pure ()
              (Escaped to, Just there) ->
                (rayName row, XYZ.distance to there)
                  `shouldSatisfy` ((< 1e-15 * raySegment row + 1e-12) . snd)
              (fate, _) -> expectationFailure (rayName row ++ ": " ++ show fate)
          | row <- rays,
            let path = pathOf row
        ]
    it "cross the plane and shift the gas's light as they should" $ do
      rays <- readKerrRays
      sequence_
        [ do
            (rayName row, length points) `shouldBe` (rayName row, length (rayCrossings row))
            sequence_
              [ do
                  pointRadius point `relatively` (1e-11, crossingRadius known)
                  cos (0.5 * pi - pointAzimuth point - crossingAzimuth known)
                    `shouldBeWithin` (1e-14, 1)
                  shift (raySpin row) ray point `relatively` (1e-12, crossingRedshift known)
                | (point, known) <- zip points (rayCrossings row)
              ]
            sequence_
              [ shift (mirrored (raySpin row)) ray {rayLambda = negate (rayLambda ray)} point
                  `relatively` (1e-12, known)
                | (point, known) <- zip points (rayLeftHanded row)
              ]
          | row <- rays,
            let ray = rayOf row
                points = kerrPlanePoints (pathOf row)
        ]

  describe "random rays" $
    modifyMaxSuccess (const 150) $ do
      prop "run as the equations of motion say, integrated step by step" $
        forAll randomSight $ \(hole, place, direction) ->
          let ray = look hole place direction
              path = kerrPath hole (BoyerLindquist 0) ray
              start =
                kerrStart
                  (placeRadius place)
                  (placePolarAngle place)
                  (rayLambda ray)
                  (rayRadialRate ray)
                  (rayPolarRate ray)
              -- The dragged frame has a pole at the horizon; stop short of it.
              time = (if captured path then 0.8 else 1) * kerrMinoTime path
              pace = 0.03 / sqrt (0.3 + abs (rayEta ray) + rayLambda ray * rayLambda ray)
              end =
                kerrAdvance
                  (spinLength hole)
                  (rayLambda ray)
                  (rayEta ray)
                  time
                  (1 + ceiling (time / pace))
                  start
              (x, y, z) = kerrDirection end
              reached = case kerrFate path of
                Escaped to -> to
                _ -> let point = kerrPoint path time in direct point
           in counterexample (show (rayLambda ray, rayEta ray, kerrMinoTime path)) $
                isInfinite time .||. nearXYZ 1e-7 (XYZ x y z) reached
      prop "are mirrored by the equatorial plane" $
        forAll randomSight $ \(hole, Place r theta, Direction nr nt np) ->
          sameFate
            ( kerrFate
                (kerrPath hole (BoyerLindquist 0) (look hole (Place r theta) (Direction nr nt np)))
            )
            ( flipped
                ( kerrFate
                    ( kerrPath
                        hole
                        (BoyerLindquist 0)
                        (look hole (Place r (pi - theta)) (Direction nr (negate nt) np))
                    )
                )
            )
      prop "are mirrored when the hole turns the other way" $
        forAll randomSight $ \(hole, place, Direction nr nt np) ->
          sameFate
            (kerrFate (kerrPath hole (BoyerLindquist 0) (look hole place (Direction nr nt np))))
            ( reversed
                ( kerrFate
                    ( kerrPath
                        (mirrored hole)
                        (BoyerLindquist 0)
                        (look (mirrored hole) place (Direction nr nt (negate np)))
                    )
                )
            )
      prop "go over into Schwarzschild's without spin, however slowly the hole turns" $
        forAll ((,) <$> randomSight <*> elements [0, 1e-12, -1e-9]) $
          \((_, Place r theta, direction@(Direction nr _ _)), s) ->
            let hole = spinOf s
                ray = look hole (Place r theta) direction
                orbit = Orbit.orbit r (nr * sqrt (1 - 1 / r)) (sqrt (1 - nr * nr))
                -- Light that winds close to the photon orbit multiplies the effect of the spin.
                allowed = 1e-7 + abs s / abs (impact ray - 1.5 * sqrt 3)
             in case (kerrFate (kerrPath hole (BoyerLindquist 0) ray), Orbit.orbitFate orbit) of
                  (Captured, Captured) -> property True
                  (Escaped to, Escaped (XY cosine _)) ->
                    counterexample
                      (show (to, cosine))
                      (abs (cosine - XYZ.dot to (XYZ 0 (cos theta) (sin theta))) < allowed)
                  (fate, other) -> counterexample (show (fate, other)) (nearlyCritical ray)

  describe "special rays" $ do
    it "straight down the axis of a fast hole end in it, and straight up at the pole" $
      sequence_
        [ kerrFate
            ( kerrPath
                (spinOf 0.99)
                (BoyerLindquist 0)
                (look (spinOf 0.99) (Place 10 0) (Direction n 0 0))
            )
            `shouldSatisfy` expected
          | (n, expected) <- [(-1, (== Captured)), (1, upwards)]
        ]
    -- Integrated with 50 digits by Taylor series, like those below.
    it "of an observer just outside the ergosphere end after the right Mino time" $
      kerrMinoTime
        ( kerrPath
            (spinOf 0.9)
            (BoyerLindquist 0)
            (look (spinOf 0.9) (Place 0.94652 (pi / 3)) (aimedAt 100 40))
        )
        `relatively` (1e-9, 8.3815275452852726492e-6)
    it "of observers on left-handed orbits have their constants and their ends" $
      sequence_
        [ case lightRay hole (Place r (inclination * pi / 180)) (OnOrbit LeftHanded) direction of
            Just ray -> do
              rayObserved ray `relatively` (1e-14, nu)
              rayLambda ray `relatively` (1e-14, lambda)
              rayEta ray `relatively` (1e-14, q)
              case (kerrFate (kerrPath hole (BoyerLindquist 0) ray), end) of
                (Escaped to, Just there) -> XYZ.distance to there `shouldSatisfy` (< 1e-12)
                (Captured, Nothing) -> pure ()
                (fate, _) -> expectationFailure (show fate)
            Nothing -> expectationFailure "no such observer"
          | (s, r, inclination, direction, (nu, lambda, q), end) <-
              [ ( 0.9,
                  6,
                  60,
                  aimedAt 100 35,
                  (0.82165328473196796999, -5.1853492430173862004, 16.677599422895184489),
                  Just (XYZ 0.90799689481908629762 0.33194021364356157688 (-0.25565080395954925541))
                ),
                ( -0.7,
                  3,
                  90,
                  aimedAt 60 (-130),
                  (1.4644082500323838403, 0.60408351706764296107, 8.494465166030931158),
                  Just (XYZ (-0.05795985152075091) 0.6943433932871638 (-0.7173060070919242))
                ),
                ( 0.5,
                  8,
                  75,
                  aimedAt 20 200,
                  (1.1271256664502786737, 0.43443979058931964099, 1.1220172155454117835),
                  Nothing
                )
              ],
            let hole = spinOf s
        ]
    it "within the plane stay there and do not cross it" $ do
      let path =
            kerrPath
              (spinOf 0.9)
              (BoyerLindquist 0)
              (look (spinOf 0.9) (Place 20 (0.5 * pi)) (aimed 0.3 0))
      length (kerrPlanePoints path) `shouldBe` 0
      case kerrFate path of
        Escaped (XYZ _ y _) -> y `shouldBeWithin` (1e-14, 0)
        fate -> expectationFailure (show fate)
    it "of an observer at rest need a place outside the ergosphere" $
      [ fmap rayRadius (lightRay (spinOf 0.9) (Place 0.9 theta) AtRest (aimed 0.3 0))
        | theta <- [0.1, 0.5 * pi]
      ]
        `shouldBe` [Just 0.9, Nothing]
    it "of a falling observer pass the horizon without a jump" $ do
      let outward r = case kerrFate
            ( kerrPath
                hole
                (Ingoing 0)
                (fromMaybe (error "dark") (lightRay hole (Place r 1.2) InFreeFall (aimed 2.2 0.4)))
            ) of
            Escaped to -> to
            _ -> XYZ 0 0 0
          hole = spinOf 0.9
          edge = horizonRadius hole
      XYZ.distance (outward (edge + 1e-9)) (outward (edge - 1e-9)) `shouldSatisfy` (< 1e-7)
  where
    rayOf row =
      fromMaybe
        (error (rayName row))
        (lightRay (raySpin row) (rayPlace row) (rayMotion row) (rayDirection row))
    pathOf row =
      kerrPath
        (raySpin row)
        (if rayMotion row == InFreeFall then Ingoing 0 else BoyerLindquist 0)
        (rayOf row)
    aimedAt psi eta = aimed (psi * pi / 180) (eta * pi / 180)
    mirrored hole = spinOf (negate (dimensionlessSpin hole))
    shift hole ray point =
      rayObserved ray
        / kerrPlaneFrequency
          (kerrFlow hole)
          ray
          (pointRadius point)
          (Momentum (if pointGrows point then -1 else 1) (rayLambda ray))
    look hole place direction =
      fromMaybe (error "no such observer") (lightRay hole place AtRest direction)
    captured path = kerrFate path == Captured
    direct point =
      let s = sqrt (1 - pointCosine point * pointCosine point)
       in XYZ (s * sin (pointAzimuth point)) (pointCosine point) (s * cos (pointAzimuth point))
    flipped fate = case fate of
      Escaped (XYZ x y z) -> Escaped (XYZ x (negate y) z)
      _ -> fate
    upwards fate = case fate of
      Escaped to -> XYZ.distance to (XYZ 0 1 0) < 1e-12
      _ -> False
    reversed fate = case fate of
      Escaped (XYZ x y z) -> Escaped (XYZ (negate x) y z)
      _ -> fate
    sameFate fate other = case (fate, other) of
      (Escaped a, Escaped b) -> nearXYZ 1e-8 a b
      _ -> fate === other
    nearlyCritical ray = abs (impact ray - 2.598) < 1e-3
    impact ray = sqrt (rayEta ray + rayLambda ray * rayLambda ray)

relatively :: HasCallStack => Double -> (Double, Double) -> Expectation
relatively value (part, known) = value `shouldBeWithin` (part * abs known, known)

-- | A hole, a place outside its ergosphere, and a direction.
randomSight :: Gen (Spin, Place, Direction)
randomSight = do
  s <- oneof [choose (-0.999, 0.999), choose (-0.05, 0.05), pure 0.998]
  r <- exp <$> choose (log 1.3, log 60)
  theta <- choose (0.02, pi - 0.02)
  -- Half of the directions near the hole.
  psi <- oneof [choose (0, pi), (\x -> x * 4 / (r + 3)) <$> choose (0, 1)]
  eta <- choose (-pi, pi)
  pure (spinOf s, Place r theta, aimed psi eta)
