module BlackHole.Spacetime.Schwarzschild.TablePathSpec (spec) where

import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.Observer
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Schwarzschild.ExactPath
import BlackHole.Spacetime.Schwarzschild.LensTable
import BlackHole.Spacetime.Schwarzschild.Radii (criticalImpactParameter)
import BlackHole.Spacetime.Schwarzschild.TablePath
import BlackHole.Spacetime.Types
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Maybe (fromMaybe)
import Support.Approx
import Support.Generators
import Support.Segments
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck hiding (tables, tolerance, total)

spec :: Spec
spec = do
  describe "random cameras and disks" $ do
    modifyMaxSuccess (const 150) $ do
      prop "have the fates and directions of the closed form" $
        forAll view $ \(View space table photon _) ->
          sameFate (sweptBy table space emptyRegion photon) (exact space emptyRegion photon)
      prop "have segments within the region" $
        forAll view $ \(View space table photon region) ->
          conjoin
            [ counterexample
                (show m)
                ( XYZ.norm m <= regionRadius region * 1.000001
                    && abs
                      y
                    <= (regionHalfHeight region + regionFlare region * XYZ.norm m)
                    * 1.000001
                    && XYZ.norm m
                    >= 0.999999
                    * regionInnerRadius region
                )
              | segment <- followedState (sweptBy table space region photon),
                let m@(XYZ _ y _) = segmentMiddle segment
            ]
      prop "have segments with the photon's own h and energy" $
        forAll view $ \(View space table photon region) ->
          conjoin
            [ belongsTo 1e-5 space photon segment
              | segment <- followedState (sweptBy table space region photon),
                segmentRadius segment > 1
            ]
      prop "have segments that follow each other" $
        -- From one middle to the next it is half of the one and half of the
        -- other, unless the path was outside the region in between.
        forAll view $ \(View space table photon region) ->
          let segments = reverse (followedState (sweptBy table space region photon))
              gap a b =
                ( XYZ.distance (segmentMiddle a) (segmentMiddle b),
                  0.5 * (segmentLength a + segmentLength b)
                )
           in conjoin
                [ counterexample (show (s, t, d, expected)) (d > 0.97 * expected)
                  | (s, t) <- zip segments (drop 1 segments),
                    let (d, expected) = gap s t
                ]
    modifyMaxSuccess (const 60) $ do
      prop "gather what the closed form gathers" $
        forAll view $ \(View space table photon region) ->
          gathersTheSame table space photon region
      prop "gather it from among the gas, along the radius as well" $
        forAll ((,) <$> elements [TableAt r t | (r, t) <- tables, r > 2] <*> inRange (-0.5) 0.5) $
          \(TableAt r' table, height) ->
            forAll ((,,) <$> inRange (-0.02) 0.02 <*> inRange (-0.02) 0.02 <*> elements [-1, 1]) $
              \(y, z, side) ->
                let region = fine (Region 20 1.5 0.1 0 1 1 1)
                    -- The place is at the table's radius.
                    place = (r' / XYZ.norm (XYZ r' (0.1 * height) 0)) *^ XYZ r' (0.1 * height) 0
                    direction = fromMaybe (XYZ 1 0 0) (XYZ.normalize (XYZ side y z))
                 in seen Schwarzschild Static place direction $ \photon ->
                      gathersTheSame table Schwarzschild photon region
  describe "special places and regions" $ do
    it "a region that is empty, or behind the camera" $
      sequence_
        [ length (followedState (swept space region photon)) `shouldBe` 0
          | space <- [Schwarzschild, Flat],
            (region, photon) <-
              [ (emptyRegion, Photon (XYZ 0 5 5) (XYZ 0 0 (-1))),
                (slab 1 12, Photon (XYZ 0 30 0) (XYZ 0 1 0)),
                (slab 1 12, Photon (XYZ 20 0 20) (XYZ (sqrt 0.5) 0 (sqrt 0.5)))
              ]
        ]
    it "a region as thick as it is wide, and one a thousand times wider" $
      sequence_
        [ affine (swept Flat region photon) `shouldBeWithin` (0.1, expected)
          | (region, photon, expected) <-
              [ -- The sphere of its radius: a chord at the distance 5.
                (slab 100 12, Photon (XYZ 5 0 40) (XYZ 0 0 (-1)), 2 * sqrt (144 - 25)),
                (slab 100 12, Photon (XYZ 5 3 40) (XYZ 0 0 (-1)), 2 * sqrt (144 - 25 - 9)),
                (slab 2 1e4, Photon (XYZ 5 30 0) (XYZ 0 (-1) 0), 4),
                (slab 2 1e4, Photon (XYZ 5 (-30) 7) (XYZ 0.6 0.8 0), 5)
              ]
        ]
    it "a region of many scales costs no more than they are" $
      sequence_
        [ followedSteps (swept Schwarzschild (slab 2 1e4) photon) `shouldSatisfy` (< 20000)
          | photon <-
              [ Photon (XYZ 5 30 0) (XYZ 0 (-1) 0),
                Photon (XYZ 30 0.1 5) (XYZ (-1) 0 0),
                Photon (XYZ 1e3 0.1 5) (XYZ (-1) 0 0)
              ]
        ]
    it "a path that turns back just outside the gas costs no more than others" $ do
      let start = XYZ 30 0.2 0
          table = lensTable (XYZ.norm start)
      maximum
        [ followedSteps
            ( sweptBy
                table
                Schwarzschild
                (slab 0.5 12)
                (Photon start (XYZ (negate (cos angle)) 0 (sin angle)))
            )
          | k <- [0 .. 400 :: Int],
            let angle = 0.36 + 0.1 * fromIntegral k / 400
        ]
        `shouldSatisfy` (< 20000)
    it "a camera in the plane that looks along it sees all of the gas there" $
      affine
        ( swept
            Flat
            (slab 0.5 12)
            (Photon (XYZ 0 0 40) (fromMaybe XYZ.zero (XYZ.normalize (XYZ 0.06 0 (-1)))))
        )
        `shouldBeWithin` (0.05, 2 * sqrt (144 - (40 * 0.06) * (40 * 0.06) / 1.0036))
    it "one on the axis sees as much in all directions" $
      sequence_
        [ affine (swept Schwarzschild (slab 0.5 12) photon)
            `shouldBeWithin` (0.02, affine (swept Schwarzschild (slab 0.5 12) first))
          | Just first <- [onAxis 0],
            k <- [1 .. 12 :: Int],
            Just photon <- [onAxis (0.5 * fromIntegral k)]
        ]
    it "light that falls straight in or comes straight out" $ do
      followedFate
        (swept Schwarzschild (slab 1 12) (Photon (XYZ 0 5 5) (XYZ 0 (-sqrt 0.5) (-sqrt 0.5))))
        `shouldBe` Captured
      affine (swept Schwarzschild (slab 1 12) (Photon (XYZ 0 20 0) (XYZ 0 (-1) 0)))
        `shouldBeWithin` (0.02, 0)
      -- Along the radius the affine length is the radius.
      affine (swept Schwarzschild (slab 2 12) (Photon (XYZ 0 20 0) (XYZ 0 (-1) 0)))
        `shouldBeWithin` (0.02, 1)
      affine (swept Schwarzschild (slab 1 12) (Photon (XYZ 4 0 0) (XYZ 1 0 0)))
        `shouldBeWithin` (0.02, 8)
    it "an opaque thing ends the path at the first segment" $
      case followTable
        Schwarzschild
        (lensTable 20)
        (slab 1 12)
        0.5
        (Photon (XYZ 5 (sqrt 375) 0) (XYZ 0 (-1) 0))
        (\n _ -> Stop (n + 1 :: Int))
        0 of
        Followed Opaque n steps -> (n, steps >= 1) `shouldBe` (1, True)
        Followed other _ _ -> expectationFailure (show other)
    it "a phase moves the segments by a part of a step and changes no total" $ do
      let at phase =
            followedState
              ( followTable
                  Schwarzschild
                  (lensTable 20)
                  (slab 1 12)
                  phase
                  (Photon (XYZ 5 (sqrt 375) 0) (XYZ 0 (-1) 0))
                  (\s t -> Continue (t : s))
                  []
              )
          total = sum . map segmentAffineLength
      -- A segment at an edge counts or does not.
      total (at 0.1) `shouldBeWithin` (0.06, total (at 0.9))
  where
    onAxis azimuth =
      sightLine
        Schwarzschild
        Static
        (XYZ 0 15 0)
        (XYZ (0.4 * cos azimuth) (-(sqrt 0.84)) (0.4 * sin azimuth))
        >>= sightPhoton

-- | A photon of unit energy, and where there is gas.
data View = View Spacetime LensTable Photon Region

instance Show View where
  show (View space _ photon region) = show (space, photon, region)

-- | Observers of all kinds, everywhere; disks of all kinds.
view :: Gen View
view = do
  space <- frequency [(1, pure Flat), (4, pure Schwarzschild)]
  observer <- elements [minBound ..]
  (r, table) <- elements (filter ((> nearest space observer) . fst) tables)
  sineLatitude <- oneof [pure 0, inRange (-1e-3) 1e-3, inRange (-1) 1]
  azimuth <- inRange 0 (2 * pi)
  outer <- inRange 3 28
  Direction anywhere <- arbitrary
  towards <- (\rho a -> outer * rho *^ XYZ (cos a) 0 (sin a)) <$> inRange 0 1 <*> inRange 0 (2 * pi)
  let cosine = sqrt (1 - sineLatitude * sineLatitude)
      place = r *^ XYZ (cosine * cos azimuth) sineLatitude (cosine * sin azimuth)
  direction <- elements [anywhere, fromMaybe anywhere (XYZ.normalize (towards ^-^ place))]
  inner <- oneof [pure 0, inRange 0.5 2.5]
  height <- (10 **) <$> inRange (-1.7) 0.3
  (constant, flare) <- elements [(height, 0), (0, height / 3), (height, height / 10)]
  case sightLine space observer place direction >>= sightPhoton of
    Just photon
      | notCritical space photon ->
        pure (View space table photon (fine (Region outer inner constant flare 1 1 1)))
    _ -> view
  where
    nearest Flat _ = 1
    nearest _ observer = observerRange Schwarzschild observer 0
    notCritical space photon =
      let b = XYZ.norm (angularMomentum photon)
       in abs (b - (if space == Flat then 1 else criticalImpactParameter)) > 1e-3

-- | A table, and how to say which.
data TableAt = TableAt Double LensTable

instance Show TableAt where
  show (TableAt r _) = show r

-- | Tables to choose from: they take longer than the paths.
tables :: [(Double, LensTable)]
tables = [(r, lensTable r) | r <- [0.3, 0.8, 1.02, 1.3, 1.5, 1.7, 2.2, 3.1, 4.5, 7, 11, 20, 60]]

seen :: Spacetime -> Observer -> XYZ -> XYZ -> (Photon -> Property) -> Property
seen space observer place direction f =
  maybe (property Discard) f (sightLine space observer place direction >>= sightPhoton)

swept :: Spacetime -> Region -> Photon -> Followed [PathSegment]
swept space region photon =
  sweptBy (lensTable (XYZ.norm (photonPosition photon))) space region photon

sweptBy :: LensTable -> Spacetime -> Region -> Photon -> Followed [PathSegment]
sweptBy table space region photon =
  followTable space table region 0.4 photon (\s t -> Continue (t : s)) []

exact :: Spacetime -> Region -> Photon -> Followed [PathSegment]
exact space region photon = followExact space region photon (\s t -> Continue (t : s)) []

affine :: Followed [PathSegment] -> Double
affine = sum . map segmentAffineLength . followedState

fine :: Region -> Region
fine region = region {regionVerticalStep = 0.06, regionLongestStep = 0.006}

slab :: Double -> Double -> Region
slab height outer = fine (Region outer 0 height 0 1 1 1)

sameFate :: Followed a -> Followed b -> Property
sameFate a b = case (followedFate a, followedFate b) of
  (Escaped d, Escaped e) -> nearXYZ 1e-6 e d
  (d, e) -> d === e

-- | The integral of a smooth density that vanishes at the region's edges; for
-- the closed form in finer steps and a larger region.
gathersTheSame :: LensTable -> Spacetime -> Photon -> Region -> Property
gathersTheSame table space photon region =
  sameFate a b .&&. closeTo (5e-3 * followedState b + 1e-3) (followedState b) (followedState a)
  where
    a = followTable space table region 0.4 photon gather 0
    b = followExact space larger photon gather 0
    larger =
      region
        { regionHalfHeight = 1.3 * regionHalfHeight region,
          regionFlare = 3 * regionFlare region,
          regionInnerRadius = 0,
          regionVerticalStep = 0.03,
          regionLongestStep = 0.004
        }
    gather total segment =
      Continue (total + segmentAffineLength segment * density (segmentMiddle segment))
    density place@(XYZ _ y _)
      | r >= regionRadius region || r <= regionInnerRadius region || abs s >= 1 = 0
      | otherwise =
        exp (-14 * s * s) * square (1 - square (r / regionRadius region))
          * square (1 - square (regionInnerRadius region / r))
      where
        r = XYZ.norm place
        s = y / (regionHalfHeight region + regionFlare region * r)
    square t = t * t :: Double
