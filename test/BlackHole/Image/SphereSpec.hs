module BlackHole.Image.SphereSpec (spec) where

import BlackHole.Image.Coding
import BlackHole.Image.Sphere
import BlackHole.Image.Write
import BlackHole.Numeric.Angle
import BlackHole.Render.Film
import BlackHole.Render.Workers
import BlackHole.Scene.Camera
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import qualified Data.ByteString.Char8 as Characters
import qualified Data.ByteString.Lazy as Lazy
import Data.List (isInfixOf)
import Data.List.NonEmpty (NonEmpty (..))
import Data.Maybe (fromMaybe, isNothing)
import Support.Tool
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec

spec :: Spec
spec = do
  it "says which part of the sphere a picture shows" $ do
    packet (view 360 (400, 200))
      `shouldSatisfy` mentions
        [ "ProjectionType=\"equirectangular\"",
          "FullPanoWidthPixels=\"400\"",
          "FullPanoHeightPixels=\"200\"",
          "CroppedAreaTopPixels=\"0\""
        ]
    packet (view 180 (400, 300))
      `shouldSatisfy` mentions
        [ "FullPanoWidthPixels=\"800\"",
          "FullPanoHeightPixels=\"400\"",
          "CroppedAreaImageWidthPixels=\"400\"",
          "CroppedAreaLeftPixels=\"200\"",
          "CroppedAreaTopPixels=\"50\""
        ]
  it "says nothing of other projections" $
    map (packet . (\p -> (view 100 (40, 20)) {sceneProjection = p})) [Perspective, Fisheye]
      `shouldSatisfy` all isNothing
  it "tells the whole sphere from a part" $
    [ isWholeSphere (metadata scene) (w, h)
      | scene@Scene
          { scenePicture = Picture w h
          } <-
          [view 360 (40, 20), view 360 (40, 18), view 350 (40, 20)]
    ]
      `shouldBe` [True, False, False]
  it "is in every format that has a place for it, for other programs to read" $
    -- OpenImageIO shows XMP of JPEG and TIFF, and the format's own mark of OpenEXR.
    withTool "oiiotool" $ \tool -> do
      shown <- mapM (information tool) ["a.jpg", "a.tif", "a.exr"]
      zipWith mentions [["equirectangular"], ["equirectangular"], ["LatLong"]] (map Just shown)
        `shouldBe` [True, True, True]
  it "stands in a PNG under the keyword of XMP" $ do
    bytes <- file Png
    Characters.unpack (Lazy.toStrict bytes)
      `shouldSatisfy` isInfixOf "iTXtXML:com.adobe.xmp\0\0\0\0\0<?xpacket"
  where
    packet scene@Scene {scenePicture = Picture width height} =
      Characters.unpack <$> spherePacket (metadata scene) (width, height)
    mentions parts = maybe False (\text -> all (`isInfixOf` text) parts)
    metadata scene = pictureMetadata "blackhole 1" defaultCoding (scene :| [])
    information tool name = withSystemTempDirectory "blackhole-spec" $ \folder -> do
      bytes <- maybe (pure Lazy.empty) file (formatOf name)
      Lazy.writeFile (folder </> name) bytes
      Characters.unpack <$> toolOutput tool ["--info", "-v", folder </> name]
    file format = do
      exposed <- exposeFilm Nothing oneWorker (const (pure ())) scene (0, 20)
      maybe
        (pure Lazy.empty)
        ( fmap (fromMaybe Lazy.empty)
            . pictureBytes oneWorker "blackhole 1" format defaultCoding (scene :| [])
        )
        exposed
      where
        scene = view 360 (40, 20)

view :: Double -> (Int, Int) -> Scene
view angle (width, height) =
  defaultScene
    { scenePicture = Picture width height,
      sceneProjection = Equirectangular,
      sceneCamera = (sceneCamera defaultScene) {cameraFieldOfView = Degrees angle},
      sceneSamples = 1,
      sceneDisk = Nothing
    }
