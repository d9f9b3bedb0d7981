module BlackHole.Image.GoldenSpec (spec) where

import BlackHole.Image.Coding
import BlackHole.Image.Metadata
import BlackHole.Render.Layer (noLayers)
import BlackHole.Render.Workers
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Disk
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Scene.Sky
import BlackHole.Spacetime.Types
import qualified Data.ByteString as Bytes
import Support.Exposing
import Support.Golden
import Test.Hspec

spec :: Spec
spec = do
  golden "default" small
  golden "report" (sized reportScene)
  golden "report-exact" (sized reportScene) {sceneIntegrator = Exact}
  golden "grid" small {sceneDisk = Nothing, sceneSky = SkyGrid}
  golden "debug-textures" (sized reportScene) {sceneDebugTextures = True}
  golden "no-gravity" small {sceneSpacetime = Flat}
  -- Later, with both patterns of turbulence in the disk and the arms turned.
  golden "later" small {sceneDisk = Just defaultDisk {diskTime = 14}, sceneSky = SkyNone}
  golden
    "later-report"
    (sized reportScene) {sceneDisk = Just reportDisk {diskTime = 9, diskTurbulence = 1}}
  golden
    "point-stars"
    small
      { sceneDisk = Nothing,
        sceneSky = SkyRandomStars defaultPointStars {pointStarsMilkyWay = 0.3}
      }
  where
    small = sized defaultScene
    sized scene = scene {scenePicture = Picture 160 90, sceneSamples = 1}
    golden name scene = it name $ do
      film <- exposeWhole oneWorker scene
      case film of
        Nothing -> expectationFailure "the scene is not valid"
        Just exposed -> do
          let development = sceneDevelopment scene
          file <-
            encoded
              oneWorker
              Png
              (Metadata "blackhole" defaultCoding Bytes.empty)
              development
              noLayers
              exposed
          maybe (expectationFailure "not encoded") (`shouldMatchGolden` name) file
