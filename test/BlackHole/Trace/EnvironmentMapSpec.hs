module BlackHole.Trace.EnvironmentMapSpec (spec) where

import BlackHole.Light.Radiance
import BlackHole.Trace.EnvironmentMap
import BlackHole.Trace.RayDifferential
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Maybe (fromMaybe)
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  prop
    "a uniform picture is a uniform sky, at every width and shape of the beam"
    $ \(Direction d) (Coordinates v) ->
      forAll ((,) <$> inRange (-5) 1 <*> inRange (-5) 1) $ \(l, m) ->
        let light =
              maybe
                black
                (`environmentMapRadiance` differentialAlong d v (10 ** l) (10 ** m))
                (environmentMapFromPixels 37 19 (\_ _ -> Radiance 0.25 0.5 2))
         in closeTo 1e-5 0 (luminance light - luminance (Radiance 0.25 0.5 2))
  it "every level sends the same light, that of the pixels by their solid angle" $ do
    let height = 23
        width = 50
        pixel i j =
          Radiance (fromIntegral ((7 * i + 3 * j) `rem` 11)) (fromIntegral j) (fromIntegral i)
        weight j =
          (cos (pi * fromIntegral j / 23) - cos (pi * fromIntegral (j + 1) / 23))
            / (2 * fromIntegral width) ::
            Double
        whole =
          foldl
            (<+>)
            black
            [scaleRadiance (weight j) (pixel i j) | i <- [0 .. width - 1], j <- [0 .. height - 1]]
    case environmentMapFromPixels width height pixel of
      Nothing -> expectationFailure "no picture"
      Just image -> do
        environmentMapMean image `near` whole
        -- The same on average through beams of the sizes of all levels' fields.
        let light = luminance whole
        sequence_
          [ averageThrough across image `shouldBeWithin` (0.01 * light, light)
            | across <- take 6 (iterate (2 *) 0.1)
          ]
  it "shows what stands where: middle, upper edge, right half" $
    case environmentMapFromPixels 64 32 (\i j -> Radiance (fromIntegral i) (fromIntegral j) 0) of
      Nothing -> expectationFailure "no picture"
      Just image -> do
        environmentMapRadiance image (thin (XYZ 0 0 (-1))) `near` Radiance 31.5 15.5 0
        let Radiance _ top _ = environmentMapRadiance image (thin (XYZ 0 1 0))
            Radiance right _ _ = environmentMapRadiance image (thin (XYZ 1 0 0))
        top `shouldBeWithin` (1e-4, 0)
        right `shouldBeWithin` (1e-3, 47.5)
        -- Turned by 90°, the middle has moved to +x.
        environmentMapRadiance image (turned (pi / 2) (thin (XYZ 1 0 0)))
          `near` Radiance 31.5 15.5 0
  it "has no seam at the edge, and none over the poles" $
    case environmentMapFromPixels 64 32 wavy of
      Nothing -> expectationFailure "no picture"
      Just image ->
        sequence_
          [ luminance (environmentMapRadiance image (thin a))
              `shouldBeWithin` (1e-3, luminance (environmentMapRadiance image (thin b)))
            | (a, b) <-
                [(unit (XYZ 1e-5 y 1), unit (XYZ (-1e-5) y 1)) | y <- [-3, -0.5, 0, 0.3, 2]]
                  ++ [ ( unit (XYZ (1e-5 * c) y (1e-5 * s)),
                         unit (XYZ (-(1e-5 * c)) y (-(1e-5 * s)))
                       )
                       | y <- [-1, 1],
                         t <- [0, 0.7, 2],
                         let (c, s) = (cos t, sin t)
                     ]
          ]
  it "light of point sources is kept" $ do
    let image =
          environmentMapFromSources
            24
            3
            (\i -> unit (XYZ (fromIntegral i) 1 (0.3 - fromIntegral i)))
            (grey . (1 +) . fromIntegral)
    environmentMapMean image `near` grey (6 / (4 * pi))
    averageThrough 0.01 image `shouldBeWithin` (0.01, 6 / (4 * pi))
  it "a long beam over a fine pattern has the light of many narrow ones" $ do
    -- Stripes and noise finer than the beam; the reference is the same bell
    -- over 33 × 33 narrow beams.
    let image = environmentMapFromDirections 256 checks
        errors =
          [ abs (wide - reference)
            | k <- [0 .. 39 :: Int],
              let t = fromIntegral k,
              let d = unit (XYZ (sin (1.7 * t)) (0.9 * cos (2.3 * t)) (cos (0.9 * t))),
              let differential = differentialAlong d (XYZ (cos t) (sin t) 0.2) 0.12 0.02,
              let wide = luminance (environmentMapRadiance image differential),
              let reference = supersampled image differential
          ]
        unfiltered =
          [ abs (luminance (environmentMapRadiance image (thin d)) - 0.5)
            | k <- [0 .. 39 :: Int],
              let t = fromIntegral k,
              let d = unit (XYZ (sin (1.7 * t)) (0.9 * cos (2.3 * t)) (cos (0.9 * t)))
          ]
    -- One look would miss by far more.
    mean unfiltered `shouldSatisfy` (> 0.2)
    mean errors `shouldSatisfy` (< 0.03)
  it "takes no harm from beams that are none" $
    case environmentMapFromPixels 8 4 (\i j -> grey (fromIntegral (i + j))) of
      Nothing -> expectationFailure "no picture"
      Just image ->
        sequence_
          [ environmentMapRadiance image differential `shouldSatisfy` isFiniteRadiance
            | bad <- [0 / 0, 1 / 0, 1e200, 0],
              differential <-
                [ RayDifferential (XYZ bad 0 1) (XYZ 1 0 0) (XYZ 0 1 0),
                  RayDifferential (XYZ 0 0 1) (XYZ bad 0 0) (XYZ 0 bad 0),
                  RayDifferential (XYZ 0 0 1) (XYZ bad 0 0) (XYZ 0 1 0)
                ]
          ]
  it "is linear between beams in a field, by halves in two, and uneven beyond" $ do
    Just image <- pure (environmentMapFromPixels 36 18 (\_ _ -> grey 1))
    let field = pi / 18
        beam angle = RayDifferential (XYZ (sin angle) 0 (cos angle)) (XYZ 0.01 0 0) (XYZ 0 0.01 0)
    [evennessBetween image (beam 0) (beam (k * field)) | k <- [0.9, 1.1, 1.9, 2.1]]
      `shouldBe` [Linear, LinearByHalves, LinearByHalves, Uneven]
  it "an empty picture is none" $
    fmap environmentMapMean (environmentMapFromPixels 0 4 (\_ _ -> black)) `shouldBe` Nothing
  where
    wavy i j = grey (1 + sin (0.3 * fromIntegral i) * cos (0.5 * fromIntegral j))
    checks (XYZ x y z) =
      grey (if even (floor (30 * x) + floor (25 * y) + floor (35 * z) :: Int) then 1 else 0)
    thin d = differentialAlong d (XYZ 0.3 0.5 0.7) 1e-6 1e-6
    mean values = sum values / fromIntegral (length values)
    near (Radiance r g b) (Radiance r' g' b') = do
      r `shouldBeWithin` (2e-4 * (1 + r'), r')
      g `shouldBeWithin` (2e-4 * (1 + g'), g')
      b `shouldBeWithin` (2e-4 * (1 + b'), b')
    supersampled image differential@(RayDifferential d a b) =
      let steps = [-1.5, -1.4 .. 1.51]
          weighted =
            [ ( w,
                luminance
                  ( environmentMapRadiance
                      image
                      (RayDifferential (unit (d ^+^ p *^ a ^+^ q *^ b)) (0.05 *^ a) (0.05 *^ b))
                  )
              )
              | p <- steps,
                q <- steps,
                let w = exp (-2 * (p * p + q * q)),
                differentialExtent differential > 0
            ]
       in sum [w * v | (w, v) <- weighted] / sum (map fst weighted)

-- | The mean over the sphere of the light through round beams of this width.
averageThrough :: Double -> EnvironmentMap -> Double
averageThrough width image = sum (map light [0 .. 9999]) / 10000
  where
    light i = luminance (environmentMapRadiance image (beam (fromIntegral (i :: Int))))
    -- Evenly over the sphere along a spiral of golden angles.
    beam i =
      let y = 1 - (2 * i + 1) / 10000
          s = sqrt (1 - y * y)
          d = XYZ (s * cos (i * 2.399963229728653)) y (s * sin (i * 2.399963229728653))
       in differentialAlong d (XYZ 0.2 0.3 0.9) width width

unit :: XYZ -> XYZ
unit v = fromMaybe (XYZ 0 0 1) (XYZ.normalize v)

-- | A beam with axes of given lengths, the first one as close to a vector as
-- its tangent plane allows.
differentialAlong :: XYZ -> XYZ -> Double -> Double -> RayDifferential
differentialAlong d v long short = RayDifferential d (long *^ a) (short *^ XYZ.cross a d)
  where
    a = unit (XYZ.cross d v)
