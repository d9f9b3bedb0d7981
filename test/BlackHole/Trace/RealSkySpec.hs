module BlackHole.Trace.RealSkySpec (spec) where

import BlackHole.Image.Digest
import BlackHole.Light.Radiance
import BlackHole.Numeric.Angle (Degrees (..))
import BlackHole.Render.Exposed
import BlackHole.Render.Workers
import BlackHole.Scene.Camera
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Scene.Sky
import BlackHole.Spacetime.Types (Spacetime (..))
import BlackHole.Trace.EnvironmentMap
import BlackHole.Trace.RayDifferential
import BlackHole.Trace.RealSky
import BlackHole.Trace.SkyFiles
import BlackHole.Trace.StarCatalogue
import BlackHole.Trace.StarField
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.List (sortOn)
import Support.Approx
import Support.Exposing
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck (NonNegative (..))

spec :: Spec
spec = do
  describe "the files" $ do
    it "are those that data/sky/README.md describes" $ do
      map (digestHex . digestBytes . Lazy.fromStrict) [starBytes, milkyWayBytes]
        `shouldBe` [ "ac25f5982607bccfa21d359a1746732f7441a14e1397002228a025e0334e5cdc",
                     "c7fe00895f00dd077a800de921f14b077924c8f143a277979b886d801b078a86"
                   ]
      starCount realStars `shouldBe` 118235
    it "decode to nothing rather than fail if bytes are missing" $ do
      starCount (decodeStars (Bytes.take 23 starBytes)) `shouldBe` 2
      starCount (decodeStars Bytes.empty) `shouldBe` 0
      fmap (isFiniteRadiance . environmentMapMean) (decodeMilkyWay Bytes.empty) `shouldBe` Just True
  describe "the stars" $ do
    it "are in order of brightness, Sirius first" $ do
      let magnitudes = map (starMagnitude realStars) [0 .. starCount realStars - 1]
      and (zipWith (<=) magnitudes (drop 1 magnitudes)) `shouldBe` True
      starMagnitude realStars 0 `shouldBeWithin` (0.011, -1.46)
      apart (starDirection realStars 0) (equatorial (6, 45, 8.92) (-16, 42, 58.0))
        `shouldSatisfy` (< 0.5 * second)
    it "stand where handbooks have them, as bright and as blue" $
      -- Bright Star Catalogue: right ascension, declination (J2000), V, B−V.
      sequence_
        [ do
            apart direction place `shouldSatisfy` (< 2 * second)
            starMagnitude realStars star `shouldBeWithin` (0.1, v)
            starTemperature realStars star
              `shouldBeWithin` (0.06 * temperatureOfColour bv, temperatureOfColour bv)
          | (place, v, bv) <- handbook,
            let star = nearest place,
            let direction = starDirection realStars star
        ]
    it "are as many and as bright as the whole sky's" $ do
      let upTo m =
            length (takeWhile (<= m) (map (starMagnitude realStars) [0 .. starCount realStars - 1]))
      -- Magnitudes are coded in steps of 0.02, over which the counts grow by 2 %.
      sequence_
        [ fromIntegral (upTo m) `shouldBeWithin` (0.02 * count + 1, count)
          | (m, count) <- [(2.001, 49), (4.001, 516), (6.001, 5042)]
        ]
      sum (map (starFlux realStars) [0 .. starCount realStars - 1]) `shouldBeWithin` (0.3, 156.0)
      -- A boundless beam sees the mean of the sphere.
      let whole = RayDifferential (XYZ 0 0 1) (XYZ (1 / 0) 0 0) (XYZ 0 (1 / 0) 0)
      (4 * pi * luminance (starFieldRadiance (starField 1 realStars) 1 whole))
        `shouldBeWithin` (0.5, 156.0)
    prop "have unit length" $ \(NonNegative i) ->
      closeTo 1e-6 1 (XYZ.norm (starDirection realStars (i `mod` 118235 :: Int)))
  describe "the Milky Way" $ do
    it "has the light of 214 stars of magnitude 0" $
      fmap ((4 * pi *) . luminance . environmentMapMean) realMilkyWay
        `shouldSatisfy` maybe False (\v -> abs (v - 214.1) < 1)
    it "has its centre, its clouds and the Magellanic clouds in their places" $ do
      let towards l b = galactic (l * degree) (b * degree)
          light l b =
            maybe
              0
              ( \image ->
                  luminance
                    ( environmentMapRadiance
                        image
                        (RayDifferential (towards l b) (XYZ 0 0 0) (XYZ 0 0 0))
                    )
              )
              realMilkyWay
      -- The Large Magellanic Cloud beside its mirror images.
      light 280.5 (-32.9)
        `shouldSatisfy` (> 5 * maximum [light 79.5 (-32.9), light 280.5 32.9, light 100.5 (-32.9)])
      -- The bulge south of the dust; the sky's poles are dark.
      light 2 (-3) `shouldSatisfy` (> 10 * light 0 90)
      light 2 (-3) `shouldSatisfy` (> 5 * light 180 (-30))
    it "has no seam at longitude 180° nor at the poles" $
      case realMilkyWay of
        Nothing -> expectationFailure "no picture"
        Just image ->
          let at l b =
                environmentMapRadiance
                  image
                  (RayDifferential (galactic (l * degree) (b * degree)) (XYZ 0 0 0) (XYZ 0 0 0))
           in sequence_
                [ luminance (at (l + 0.01) b)
                    `shouldBeWithin` (0.02 * luminance (at l b), luminance (at (l - 0.01) b))
                  | (l, b) <-
                      [(180, b) | b <- [-80, -40, -10, -3, 0, 2, 7, 30, 70]]
                        ++ [(l, s * 89.99) | l <- [0, 77 .. 360], s <- [1, -1]]
                ]
  describe "the frame" $ do
    prop "turns without stretching or mirroring" $ \(Direction a) (Direction b) ->
      let turn = toRealSky 0.7
       in closeTo 1e-12 0 (XYZ.norm (XYZ.cross (turn a) (turn b) ^-^ turn (XYZ.cross a b)))
    it "has the galactic pole and centre where the IAU has them" $ do
      -- ESA SP-1200, volume 1, section 1.5.3.
      apart (fromEquatorial (192.85948 * degree) (27.12825 * degree)) (XYZ 0 1 0)
        `shouldSatisfy` (< second)
      apart (fromEquatorial (266.4051 * degree) (-28.936175 * degree)) (XYZ 0 0 (-1))
        `shouldSatisfy` (< second)
    it "turns as a panorama does" $ do
      let differential = RayDifferential (XYZ 0.6 0 (-0.8)) (XYZ 0.8e-3 0 0.6e-3) (XYZ 0 1e-3 0)
          d = differentialDirection (turned 0.4 differential)
      XYZ.norm (toRealSky 0.4 (differentialDirection differential) ^-^ toRealSky 0 d)
        `shouldBeWithin` (1e-12, 0)
  describe "on film, without gravity" $ do
    it "Orion's belt is a line of three, evenly spaced, and falls to the left when north is up" $ do
      let (place, middle, place') =
            ( equatorial (5, 32, 0.40) (0, -17, -56.7),
              equatorial (5, 36, 12.81) (-1, 12, 6.9),
              equatorial (5, 40, 45.53) (-1, 56, 33.3)
            )
      found <- brightSpots 3 middle (equatorial (5, 36, 12.81) (89, 0, 0)) (Degrees 6) 0
      -- West, where Mintaka is, is on the right; the belt falls to the left.
      case sortOn (negate . fst) found of
        [mintaka, alnilam, alnitak] -> do
          distance mintaka alnilam `shouldBeWithin` (0.01, apart place middle / degree)
          distance alnilam alnitak `shouldBeWithin` (0.01, apart middle place' / degree)
          alnilam `shouldSatisfy` (\(x, y) -> abs x < 0.01 && abs y < 0.01)
          mintaka `shouldSatisfy` (\(x, y) -> x > 1 && y > 0.7)
          alnitak `shouldSatisfy` (\(x, y) -> x < -1 && y < -0.6)
        other -> expectationFailure (show other)
    it "the Southern Cross has its four arms, also in a turned sky" $
      sequence_
        [ do
            found <-
              brightSpots
                4
                (equatorial (12, 31, 0) (-60, 0, 0))
                (equatorial (12, 31, 0) (0, 0, 0))
                (Degrees 10)
                rotation
            -- Gacrux above, Acrux below, Mimosa on the left (east), Imai on the right.
            case (sortOn fst found, sortOn snd found) of
              ([mimosa, _, _, imai], [acrux, _, _, gacrux]) -> do
                distance acrux gacrux
                  `shouldBeWithin` ( 0.02,
                                     apart
                                       (equatorial (12, 26, 35.90) (-63, 5, 56.7))
                                       (equatorial (12, 31, 9.96) (-57, 6, 47.6))
                                       / degree
                                   )
                distance mimosa imai
                  `shouldBeWithin` ( 0.02,
                                     apart
                                       (equatorial (12, 47, 43.27) (-59, 41, 19.6))
                                       (equatorial (12, 15, 8.72) (-58, 44, 56.1))
                                       / degree
                                   )
                fst mimosa `shouldSatisfy` (< -1)
                fst imai `shouldSatisfy` (> 1)
                snd gacrux `shouldSatisfy` (> 2)
                snd acrux `shouldSatisfy` (< -2)
              other -> expectationFailure (show other)
          | rotation <- [0, 130]
        ]
  where
    degree = pi / 180
    second = degree / 3600
    equatorial :: (Double, Double, Double) -> (Double, Double, Double) -> XYZ
    equatorial (h, m, s) (d, dm, ds) =
      fromEquatorial
        (15 * degree * (h + m / 60 + s / 3600))
        (degree * (d + signum' d * (dm / 60 + ds / 3600)))
    signum' d = if d < 0 then -1 else 1
    galactic l b = XYZ (negate (cos b * sin l)) (sin b) (negate (cos b * cos l))
    apart a b = 2 * asin (min 1 (0.5 * XYZ.norm (a ^-^ b)))
    nearest place = snd (minimum [(apart (starDirection realStars i) place, i) | i <- [0 .. 399]])
    handbook =
      [ (equatorial (18, 36, 56.34) (38, 47, 1.3), 0.03, 0.00), -- Vega
        (equatorial (5, 55, 10.31) (7, 24, 25.4), 0.50, 1.85), -- Betelgeuse
        (equatorial (5, 14, 32.27) (-8, 12, 5.9), 0.12, -0.03), -- Rigel
        (equatorial (2, 31, 49.09) (89, 15, 50.8), 2.02, 0.60), -- Polaris
        (equatorial (16, 29, 24.46) (-26, 25, 55.2), 0.96, 1.83), -- Antares
        (equatorial (12, 47, 43.27) (-59, 41, 19.6), 1.25, -0.23), -- Mimosa
        (equatorial (4, 35, 55.24) (16, 30, 33.5), 0.85, 1.54) -- Aldebaran
      ]
    distance (x, y) (x', y') = sqrt ((x - x') ** 2 + (y - y') ** 2)

-- | The brightest spots of a picture of the sky around a direction of the real sky's
-- frame, with another direction above: degrees to the right and upwards.
brightSpots :: Int -> XYZ -> XYZ -> Degrees -> Double -> IO [(Double, Double)]
brightSpots count middle above (Degrees fov) rotation = do
  film <- exposeWhole oneWorker scene
  pure $ case film of
    Nothing -> []
    Just exposed ->
      let light x y = maybe 0 luminance (filmRadiance exposed x y)
          peaks =
            sortOn
              (negate . fst)
              [ (total, (px, py))
                | x <- [3 .. side - 4],
                  y <- [3 .. side - 4],
                  let here = light x y,
                  here > 0.5,
                  and
                    [ here > light (x + i) (y + j)
                        || (here == light (x + i) (y + j) && (i, j) > (0, 0))
                      | i <- [-2 .. 2],
                        j <- [-2 .. 2],
                        (i, j) /= (0, 0)
                    ],
                  let weights = [(light (x + i) (y + j), i, j) | i <- [-3 .. 3], j <- [-3 .. 3]],
                  let total = sum [w | (w, _, _) <- weights],
                  let px = fromIntegral x + sum [w * fromIntegral i | (w, i, _) <- weights] / total,
                  let py = fromIntegral y + sum [w * fromIntegral j | (w, _, j) <- weights] / total
              ]
       in map (angles . snd) (take count peaks)
  where
    side = 240 :: Int
    focal = 0.5 * fromIntegral side / tan (0.5 * fov * pi / 180)
    angles (x, y) =
      (offset (x + 0.5 - 0.5 * fromIntegral side), offset (0.5 * fromIntegral side - y - 0.5))
    offset v = atan (v / focal) * 180 / pi
    scene =
      defaultScene
        { scenePicture = Picture side side,
          -- North up: rolled by the angle between that and the scene's own.
          sceneCamera =
            Camera (LookAt place (place ^+^ ahead)) (Degrees (roll * 180 / pi)) (Degrees fov),
          sceneSpacetime = Flat,
          sceneDisk = Nothing,
          sceneSamples = 1,
          sceneNoise = 0,
          sceneBloom = 0,
          sceneSky = SkyStars realSky {realSkyRotation = Degrees rotation, realSkyMilkyWay = 0}
        }
    place = XYZ 0 0 10
    ahead = fromFrame middle
    up = XYZ 0 1 0 ^-^ XYZ.dot (XYZ 0 1 0) ahead *^ ahead
    right = XYZ.cross ahead up
    wanted = fromFrame above
    roll = atan2 (XYZ.dot wanted right / XYZ.norm right) (XYZ.dot wanted up / XYZ.norm up)
    -- The transpose of the turn into the frame.
    fromFrame (XYZ x y z) = XYZ (dots (XYZ 1 0 0)) (dots (XYZ 0 1 0)) (dots (XYZ 0 0 1))
      where
        dots axis = XYZ.dot (XYZ x y z) (toRealSky (rotation * pi / 180) axis)
