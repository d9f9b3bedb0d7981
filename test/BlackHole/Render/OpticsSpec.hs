module BlackHole.Render.OpticsSpec (spec) where

import BlackHole.Numeric.Angle
import BlackHole.Render.Beam
import BlackHole.Render.Exposed
import BlackHole.Render.Optics
import BlackHole.Render.PixelArray
import BlackHole.Render.PixelShape
import BlackHole.Render.Pyramid (FilmBands)
import BlackHole.Render.Spikes
import BlackHole.Render.Workers
import BlackHole.Scene.Camera
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Scene.Validate
import Control.Monad (forM_)
import Data.Maybe (mapMaybe)
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as Vector
import Support.Approx
import Support.Exposing
import Test.Hspec

spec :: Spec
spec = do
  describe "beam" $ do
    it "is a Gaussian of its width, at any width" $
      forM_ [1, 1.5, 3, 5, 9.7, 14] $ \sigma -> do
        light <- through (beamBands oneWorker sigma) 200 160 (pointAt 200 97 71)
        let moment :: (Double -> Double -> Double) -> Double
            moment f =
              sum
                [ f (fromIntegral x) (fromIntegral y)
                    * realToFrac (light Vector.! (3 * (200 * y + x) + 1))
                  | x <- [0 .. 199 :: Int],
                    y <- [0 .. 159 :: Int]
                ]
        moment (\_ _ -> 1) `shouldBeWithin` (0.01, 1)
        moment (\x _ -> (x - 97) ** 2) `shouldBeWithin` (0.02 * sigma * sigma, sigma * sigma)
        moment (\_ y -> (y - 71) ** 2) `shouldBeWithin` (0.02 * sigma * sigma, sigma * sigma)
        -- Its shape, not only its width.
        forM_ [(dx, dy) | sigma >= 3, dx <- [0, 7, -12], dy <- [0, 9, -5 :: Int]] $ \(dx, dy) -> do
          let exact =
                exp (-0.5 * fromIntegral (dx * dx + dy * dy) / (sigma * sigma))
                  / (2 * pi * sigma * sigma)
          realToFrac (light Vector.! (3 * (200 * (71 + dy) + 97 + dx) + 1))
            `shouldBeWithin` (0.03 / (2 * pi * sigma * sigma), exact)
    it "leaves a uniform picture as it is, to its edges" $
      forM_ [(1, 1), (64, 36), (61, 33)] $ \(width, height) -> do
        light <- through (beamBands oneWorker 7) width height (const 3)
        (Vector.minimum light, Vector.maximum light) `shouldSatisfy` \(low, high) ->
          low > 3 - 2e-5 && high < 3 + 2e-5
  describe "spikes" $ do
    it "keep the light of a point in the middle" $ do
      light <- through (spikeBands oneWorker 4 0.5) 300 300 (pointAt 300 150 150)
      sum (map realToFrac (Vector.toList light)) `shouldBeWithin` (0.01, 1 :: Double)
      Vector.minimum light `shouldSatisfy` (>= 0)
    it "are as many as the edges, twice as many for an odd number, and one points up" $
      forM_ [(4, 4), (6, 6), (3, 6), (5, 10)] $ \(blades, count) -> do
        light <- through (spikeBands oneWorker blades 1) 300 300 (pointAt 300 150 150)
        -- On a circle, over steps of a degree.
        let circle =
              [ sample light (150 + 60 * sin a) (150 - 60 * cos a)
                | d <- [0 .. 359 :: Int],
                  let a = fromIntegral d * pi / 180
              ]
            peaks =
              length
                [ ()
                  | (left, here, right) <-
                      zip3 (drop 359 circle ++ circle) circle (drop 1 circle ++ take 1 circle),
                    here > left,
                    here >= right,
                    here > 0.3 * maximum circle
                ]
        peaks `shouldBe` count
        take 1 circle `shouldSatisfy` all (> 0.5 * maximum circle)
  it "has the same bytes for any number of workers" $ do
    films <-
      mapM
        ( \workers ->
            toPixelVector
              <$> opticsFilm
                workers
                scene {scenePicture = Picture 61 33}
                (filmOf 61 33 fromIntegral)
        )
        (mapMaybe workersFromCount [1, 2, 3])
    films `shouldSatisfy` all (\film -> take 1 films == [film])
  it "does not spread a fault" $ do
    film <-
      opticsFilm
        oneWorker
        scene {scenePicture = Picture 64 36, sceneScaleBar = 0}
        (filmOf 64 36 (\i -> if i == 3000 then 0 / 0 else 1))
    Vector.length (Vector.filter (\v -> isNaN v || isInfinite v) (toPixelVector film)) `shouldBe` 1
  describe "scale bar" $ do
    it "is as long as it says beside the hole, and white" $ do
      -- 20 radii at a distance of 50 in a picture of 90 degrees.
      let far =
            plain
              { sceneCamera = Camera (Around 50 (Degrees 80) (Degrees 0)) (Degrees 0) (Degrees 90),
                scenePicture = Picture 400 225,
                sceneScaleBar = 20
              }
      film <- toPixelVector <$> opticsFilm oneWorker far (filmOf 400 225 (const 0))
      let rows = [[film Vector.! (3 * (400 * y + x)) | x <- [0 .. 399]] | y <- [0 .. 224]]
      (realToFrac (maximum (map sum rows)) / 4) `shouldBeWithin` (0.01, 80 :: Double)
      maximum (concat rows) `shouldBe` 4
      length (filter ((> 0) . sum) rows) `shouldSatisfy` (<= 3)
    it "must fit into the picture" $
      map problemOption (validateScene plain {sceneScaleBar = 40}) `shouldBe` ["--scale-bar"]
  describe "the preset m87" $
    it "shows a ring as large as the shadow, brightest in the south, with a dim middle" $
      case findPreset "m87" of
        Nothing -> expectationFailure "there is no such preset"
        Just m87 -> do
          exposed <- exposeWhole oneWorker m87 {scenePicture = Picture 164 92}
          light <-
            maybe
              (pure Vector.empty)
              ( fmap toPixelVector
                  . opticsFilm oneWorker m87 {scenePicture = Picture 164 92, sceneScaleBar = 0}
              )
              exposed
          -- One pixel is one microarcsecond. The profile along a radius, over position angles.
          let profile angle =
                [sample light (82 + r * sin angle) (46 - r * cos angle) | r <- [0 .. 35]]
              brightest angle = let p = profile angle in length (takeWhile (< maximum p) p)
              angles = [2 * pi * fromIntegral k / 16 | k <- [0 .. 15 :: Int]] :: [Double]
              diameters =
                [fromIntegral (brightest a + brightest (a + pi)) | a <- take 8 angles] :: [Double]
              north = maximum (profile 0)
              south = maximum (profile pi)
          sum diameters / 8 `shouldSatisfy` \d -> d > 36 && d < 44
          south / north `shouldSatisfy` \q -> q > 1.3 && q < 3
          sample light 82 46 / (sum (map (maximum . profile) angles) / 16) `shouldSatisfy` (< 0.7)
  where
    scene =
      defaultScene
        { sceneBeam = 1,
          sceneBloom = 0.3,
          sceneSpikes = 6,
          sceneSpikeLight = 0.2,
          sceneScaleBar = 5
        }
    plain = defaultScene {sceneBloom = 0}

sample :: Vector Float -> Double -> Double -> Double
sample light x y = realToFrac (light Vector.! (3 * (round y * width + round x) + 1))
  where
    width = if Vector.length light == 3 * 300 * 300 then 300 else 164

pointAt :: Int -> Int -> Int -> Int -> Float
pointAt width x y i = if i == 3 * (y * width + x) + 1 then 1 else 0

through ::
  (PixelShape -> FilmBands -> IO (Maybe FilmBands)) ->
  Int ->
  Int ->
  (Int -> Float) ->
  IO (Vector Float)
through effect width height amount = do
  bands <- effect (pixelArrayShape film) (pure . filmRows film)
  result <- maybe (pure Nothing) ($ (0, height)) bands
  maybe (fail "the effect lost rows") (pure . toPixelVector) result
  where
    film = filmOf width height amount

filmOf :: Int -> Int -> (Int -> Float) -> Film
filmOf width height amount =
  case pixelShape width height 3 >>= \shape ->
    fromPixelVector shape (Vector.generate (3 * width * height) amount) of
    Just film -> film
    Nothing -> error "the test's picture has no pixels"
