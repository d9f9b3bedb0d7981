module BlackHole.Render.FilmSpec (spec) where

import BlackHole.Light.Display
import BlackHole.Light.Dither (Dither (..))
import BlackHole.Numeric.Angle (Degrees (..))
import BlackHole.Render.Exposed
import BlackHole.Render.Film
import BlackHole.Render.PixelArray (toPixelVector)
import BlackHole.Render.Workers
import BlackHole.Scene.Camera (Camera (..), Picture (..))
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Scene.Sky (Sky (..))
import BlackHole.Trace.Adaptive (Pixel (..), singlePixel)
import BlackHole.Trace.Tracer (tracer)
import qualified Data.Vector.Storable as Vector
import Data.Word (Word8)
import Support.Exposing
import Test.Hspec

spec :: Spec
spec = do
  it "has equal bytes for any number of workers" $ do
    one <- developed 1
    others <- mapM developed [2, 3, 7]
    map (== one) others `shouldBe` [True, True, True]
    fmap (Vector.length . Vector.filter (> 100)) one `shouldSatisfy` maybe False (> 100)
  it "has no faulty pixel" $ do
    film <- exposeWhole oneWorker small
    traverse (faultyPixels oneWorker) film `shouldReturn` Just (0, Nothing)
  it "does not trace an invalid scene" $ do
    film <- exposeWhole oneWorker small {scenePicture = Picture 0 1}
    traverse (faultyPixels oneWorker) film `shouldReturn` Nothing
  it "has the same light in a band as in the whole" $ do
    whole <- exposeWhole oneWorker small
    bands <- mapM (exposeBand oneWorker small) [(0, 5), (5, 1), (6, 21)]
    fmap (Vector.concat . map toPixelVector) (sequence bands) `shouldBe` fmap toPixelVector whole
  describe "adaptive sampling" $ do
    it "has the same light in a band as in the whole" $ do
      whole <- exposeWhole oneWorker searching
      bands <- mapM (exposeBand oneWorker searching) [(0, 11), (11, 1), (12, 15)]
      fmap (Vector.concat . map toPixelVector) (sequence bands) `shouldBe` fmap toPixelVector whole
    it "counts each pixel's samples as the pixel by itself does" $ do
      exposed <- exposeFilm Nothing oneWorker (const (pure ())) searching (0, 27)
      case (exposed, tracer searching) of
        (Just whole, Just traced) -> do
          let counts = Vector.concat (map (countsRow searching whole) [0 .. 26])
          Vector.toList counts
            `shouldBe` [ fromIntegral (pixelRays (singlePixel traced column row))
                         | row <- [0 .. 26],
                           column <- [0 .. 47]
                       ]
          (Vector.minimum counts, Vector.maximum counts) `shouldBe` (4, 64)
          countsRow searching whole 27 `shouldBe` Vector.replicate 48 0
        _ -> expectationFailure "no film"
    it "has the same light in a band as in a whole of many" $ do
      whole <- exposeWhole oneWorker tall
      band <- exposeBand oneWorker tall (200, 100)
      fmap toPixelVector band
        `shouldBe` fmap (Vector.slice (3 * 8 * 200) (3 * 8 * 100) . toPixelVector) whole
    it "comes closer to a picture of 256 samples than as many samples spread evenly" $ do
      -- Both take the same time here (measured).
      reference <- exposeWhole oneWorker even' {sceneSamples = 256}
      evenly <- exposeWhole oneWorker even' {sceneSamples = 8}
      adaptive <- exposeWhole oneWorker searching
      case (,,) <$> reference <*> evenly <*> adaptive of
        Just (r, e, a) -> rmse a r `shouldSatisfy` (< 0.75 * rmse e r)
        Nothing -> expectationFailure "no film"
  it "has no band beyond the picture" $ do
    bands <- mapM (exposeBand oneWorker small) [(-1, 5), (27, 1), (20, 8), (3, 0)]
    map (fmap toPixelVector) bands `shouldBe` [Nothing, Nothing, Nothing, Nothing]

small :: Scene
small = defaultScene {scenePicture = Picture 48 27, sceneSamples = 1}

-- | The ring of light, where all is decided.
even', searching :: Scene
even' =
  defaultScene
    { scenePicture = Picture 48 27,
      sceneNoise = 0,
      sceneSky = SkyNone,
      sceneCamera = (sceneCamera defaultScene) {cameraFieldOfView = Degrees 16}
    }
searching = even' {sceneSamples = 4, sceneNoise = 0.02, sceneMostSamples = 64}

-- | A strip through the middle.
tall :: Scene
tall =
  searching
    { scenePicture = Picture 8 530,
      sceneCamera = (sceneCamera defaultScene) {cameraFieldOfView = Degrees 0.4}
    }

-- | Of what a display shows.
rmse :: Film -> Film -> Double
rmse a b =
  sqrt
    ( Vector.sum (Vector.zipWith difference (toPixelVector a) (toPixelVector b))
        / fromIntegral (Vector.length (toPixelVector a))
    )
  where
    difference x y = realToFrac ((shown x - shown y) ^ (2 :: Int))
    shown v = sqrt (min 1 v)

developed :: Int -> IO (Maybe (Vector.Vector Word8))
developed n = case workersFromCount n of
  Nothing -> pure Nothing
  Just workers -> withWorkers workers $ do
    film <- exposeWhole workers small
    traverse
      ( fmap toPixelVector
          . developFilm workers (Development (Exposure 0) ToneFilm noGrain BlueNoise)
      )
      film
