module BlackHole.Animation.ExposureSpec (spec) where

import BlackHole.Animation.Exposure
import BlackHole.Numeric.Angle
import BlackHole.Render.Exposed
import BlackHole.Render.Film (exposeFilm)
import BlackHole.Render.PixelArray (toPixelVector)
import BlackHole.Render.Workers
import BlackHole.Scene.Camera
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import Data.IORef
import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.Vector.Storable as Vector
import Support.Exposing
import Test.Hspec

spec :: Spec
spec = do
  it "is the film itself for a single scene" $ do
    alone <- exposeWhole oneWorker (turned 0)
    exposed <- blurred (turned 0 :| [])
    fmap (toPixelVector . exposedLight) exposed `shouldBe` fmap toPixelVector alone
  it "is the mean of the light of several, not of what a display shows of it" $ do
    films <- mapM (exposeWhole oneWorker . turned) [0, 5, 10]
    exposed <- blurred (turned 0 :| [turned 5, turned 10])
    case (mapM (fmap toPixelVector) films, toPixelVector . exposedLight <$> exposed) of
      (Just [a, b, c], Just mean) -> do
        Vector.maximum
          (Vector.zipWith4 (\x y z m -> abs ((x + y + z) / 3 - m) / (1 + abs m)) a b c mean)
          `shouldSatisfy` (< 1e-6)
        Vector.length (Vector.filter (> 0.01) (Vector.zipWith (\x m -> abs (x - m)) a mean))
          `shouldSatisfy` (> 20)
      _ -> expectationFailure "no film"
  it "counts the samples of all scenes" $ do
    exposed <- blurred (turned 0 :| [turned 5, turned 10])
    let expose scene = exposeFilm Nothing oneWorker (const (pure ())) scene (0, 9)
    alone <- mapM (expose . turned) [0, 5, 10]
    let counts = fmap toPixelVector . (exposedCounts =<<)
    counts exposed `shouldBe` fmap (foldr1 (Vector.zipWith (+))) (mapM counts alone)
    fmap Vector.maximum (counts exposed) `shouldBe` Just 192
  it "tells of growing parts up to the whole" $ do
    parts <- newIORef []
    _ <-
      exposeMotionBlur
        Nothing
        oneWorker
        (\part -> modifyIORef parts (part :))
        -- Rows that take long enough for a report of each.
        ((turned 0) {scenePicture = Picture 320 9} :| [(turned 5) {scenePicture = Picture 320 9}])
        (0, 9)
    told <- readIORef parts
    (take 1 told, and (zipWith (>) told (drop 1 told))) `shouldBe` ([1], True)
  it "does not mix pictures of different size" $ do
    exposed <- blurred (turned 0 :| [(turned 0) {scenePicture = Picture 16 8}])
    fmap (toPixelVector . exposedLight) exposed `shouldBe` Nothing

blurred :: NonEmpty Scene -> IO (Maybe Exposed)
blurred scenes = exposeMotionBlur Nothing oneWorker (const (pure ())) scenes (0, 9)

turned :: Double -> Scene
turned azimuth =
  defaultScene
    { scenePicture = Picture 16 9,
      sceneSamples = 1,
      sceneCamera =
        (sceneCamera defaultScene) {cameraPose = Around 30 (Degrees 82) (Degrees (90 + azimuth))}
    }
