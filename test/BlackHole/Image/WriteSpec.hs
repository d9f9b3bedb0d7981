module BlackHole.Image.WriteSpec (spec) where

import BlackHole.Image.Coding
import BlackHole.Image.Destination
import BlackHole.Image.Write
import BlackHole.Light.Display
import BlackHole.Render.Exposed
import BlackHole.Render.PixelArray
import BlackHole.Render.PixelShape
import BlackHole.Render.Workers
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import Codec.Picture
import Control.Monad (forM_, (>=>))
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.Vector.Storable as Vector
import System.FilePath ((</>))
import System.IO (IOMode (..), withBinaryFile)
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec

spec :: Spec
spec =
  describe "a picture's codes are the film's light, exposed and developed once" $
    forM_ [(bits, stops) | bits <- [8, 16], stops <- [-1, 0, 1.5]] $ \(bits, stops) ->
      it (show bits ++ " bits, " ++ show stops ++ " stops") $ do
        let exposed = scene {sceneExposure = Exposure stops}
        expected <- codesOf bits exposed
        whole <-
          pictureBytes
            oneWorker
            "blackhole"
            Png
            (Coding (Just bits) Nothing)
            (exposed :| [])
            (Exposed film Nothing)
        fmap (codesIn . Lazy.toStrict) whole `shouldBe` Just expected
        banded <- inBands bits exposed
        codesIn banded `shouldBe` expected
  where
    scene = defaultScene {scenePicture = Picture 12 7, sceneBloom = 0, sceneGrain = 200}
    film = case pixelShape 12 7 3
      >>= (`fromPixelVector` Vector.generate (3 * 12 * 7) (\i -> fromIntegral i / 300)) of
      Just pixels -> pixels
      Nothing -> error "the test's picture has another size"
    codesOf :: Int -> Scene -> IO (Vector.Vector Int)
    codesOf bits exposed
      | bits == 16 =
        Vector.map fromIntegral . toPixelVector
          <$> developFilmFinely oneWorker (sceneDevelopment exposed) 0 film
      | otherwise =
        Vector.map fromIntegral . toPixelVector
          <$> developFilm oneWorker (sceneDevelopment exposed) film
    codesIn :: Bytes.ByteString -> Vector.Vector Int
    codesIn bytes = case decodePng bytes of
      Right (ImageRGB8 image) -> Vector.map fromIntegral (imageData image)
      Right (ImageRGB16 image) -> Vector.map fromIntegral (imageData image)
      _ -> Vector.empty
    inBands bits exposed = withSystemTempDirectory "blackhole-spec" $ \folder -> do
      let write =
            pictureEncoder
              oneWorker
              "blackhole"
              Png
              (Coding (Just bits) Nothing)
              (exposed :| [])
              (const (pure Vector.empty))
      forM_ write $ \encode ->
        withBinaryFile (folder </> "a.png") WriteMode (toHandle >=> encode (pure . filmRows film))
      Bytes.readFile (folder </> "a.png")
