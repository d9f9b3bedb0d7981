module BlackHole.Trace.ExplainSpec (spec) where

import BlackHole.Light.Radiance
import BlackHole.Numeric.Angle
import BlackHole.Render.Exposed
import BlackHole.Render.PixelRows (pixelChannels)
import BlackHole.Render.Workers
import BlackHole.Scene.Camera
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Scene.Sky
import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Observer
import BlackHole.Spacetime.Photon (angularMomentum)
import BlackHole.Trace.Adaptive (sharedWorth)
import BlackHole.Trace.Explain
import BlackHole.Trace.Tracer
import BlackHole.Vector.XY (XY (..))
import qualified BlackHole.Vector.XYZ as XYZ
import Control.Monad (forM_)
import Data.Maybe (isJust)
import qualified Data.Vector.Storable as Vector
import Support.Approx
import Support.Exposing
import Test.Hspec

spec :: Spec
spec = do
  describe "the codes are those of the rendered picture" $
    forM_ scenes $ \(name, scene) ->
      it name $ do
        exposed <- exposeWhole oneWorker scene
        case (,) <$> exposed <*> tracer scene of
          Nothing -> expectationFailure "cannot be traced"
          Just (film, traced) -> do
            picture <- developFilm oneWorker (sceneDevelopment scene) film
            forM_ [(x, y) | x <- [0, 2 .. 7], y <- [0, 2 .. 4]] $ \(x, y) ->
              fmap
                ((\(r, g, b) -> [r, g, b]) . shownCodes . explainedShown)
                (explainPixel traced x y)
                `shouldBe` (Vector.toList <$> pixelChannels picture x y)
  it "the pixel is the mean of its samples and of what it shares with its neighbours" $
    -- Layers are kept in single precision.
    forM_ [(small {sceneNoise = 0, sceneSamples = 4}, 1e-12), (small, 1e-6)] $ \(scene, allowed) ->
      forM_ (everyPixel scene) $ \explanation -> do
        let samples = explainedSamples explanation
            neighbours = explainedShared explanation
            light =
              [(sightingWeight s, sightingRadiance s) | s <- samples]
                ++ [(fromIntegral sharedWorth, shared) | Just shared <- [neighbours]]
            mean =
              scaleRadiance
                (1 / sum (map fst light))
                (mconcat [scaleRadiance weight radiance | (weight, radiance) <- light])
        if sceneNoise scene == 0
          then length samples `shouldBe` sceneSamples scene
          else
            isJust neighbours
              || length samples `elem` map (mostSamples scene `quot`) [1, 2]
                `shouldBe` True
        distant mean (explainedRadiance explanation) `shouldSatisfy` (< allowed)
  it "a single sample is the middle" $
    forM_ (everyPixel small {sceneNoise = 0}) $ \explanation ->
      explainedSamples explanation `shouldBe` [explainedMiddle explanation]
  it "gas and sky add up to what is seen" $
    forM_
      [ s
        | explanation <-
            everyPixel small,
          s <- explainedMiddle explanation : explainedSamples explanation
      ]
      $ \s ->
        case sightingArrival s of
          Nothing -> sightingRadiance s `shouldBe` black
          Just light ->
            distant
              (arrivalGas light <+> scaleRadiance (arrivalTransmittance light) (arrivalSky light))
              (sightingRadiance s)
              `shouldSatisfy` (< 1e-12)
  it "tells the observer's light path" $
    case tracer small >>= \traced ->
      (,) <$> explainPixel traced 4 3 <*> tracedSight traced (XY 4.5 3.5) of
      Just (explanation, SightLine photon observed) ->
        case sightingArrival (explainedMiddle explanation) of
          Just light -> do
            arrivalConstants light `shouldBe` AngularMomentum (angularMomentum photon)
            arrivalFrequency light `shouldBe` observed
            observed `shouldBeWithin` (1e-14, 1 / sqrt (1 - 1 / 54))
          Nothing -> expectationFailure "no light"
      _ -> expectationFailure "no explanation"
  it "the middle of a bare hole is captured, without gas, at b = 0" $
    case sightingArrival . explainedMiddle
      <$> (tracer bare >>= \traced -> explainPixel traced 8 4) of
      Just (Just light) -> do
        arrivalFate light `shouldBe` Captured
        case arrivalConstants light of
          AngularMomentum h -> XYZ.norm h `shouldBeWithin` (1e-12, 0)
          constants -> expectationFailure (show constants)
        (arrivalGasSamples light, opticalDepth light, arrivalGas light, arrivalSky light)
          `shouldBe` (0, 0, black, black)
      other -> expectationFailure (show other)
  it "counts the gas: some where the transmittance is below 1, none elsewhere" $
    forM_ [light | e <- everyPixel small, Just light <- [sightingArrival (explainedMiddle e)]] $
      \light ->
        (arrivalGasSamples light > 0, arrivalGasSamples light <= arrivalSteps light)
          `shouldBe` (arrivalTransmittance light < 1, True)
  it "knows nothing outside the picture" $
    map
      (\(x, y) -> tracer small >>= \traced -> explainPixel traced x y)
      [(-1, 0), (0, -1), (8, 0), (0, 5)]
      `shouldBe` [Nothing, Nothing, Nothing, Nothing]
  where
    small = defaultScene {scenePicture = Picture 8 5}
    bare =
      small
        { scenePicture = Picture 17 9,
          sceneDisk = Nothing,
          sceneSky = SkyUniform 1,
          sceneSamples = 1
        }
    scenes =
      [ ("shared rays", small),
        ("four samples", small {sceneSamples = 4, sceneNoise = 0}),
        ("one sample, no tone map", small {sceneNoise = 0, sceneToneMap = minBound}),
        ("the report's scene", reportScene {scenePicture = Picture 8 5}),
        ("from within the photon sphere", small {sceneCamera = near 1.3, sceneSky = SkyGrid}),
        ( "falling, inside the horizon",
          small {sceneCamera = near 0.7, sceneObserver = Falling, sceneSky = SkyGrid}
        ),
        ("parity checks", small {sceneDebugTextures = True})
      ]
    near r = (sceneCamera small) {cameraPose = Around r (Degrees 80) (Degrees 90)}
    everyPixel scene =
      [ e
        | Just traced <- [tracer scene],
          x <- [0, 2 .. 7],
          y <- [1, 3],
          Just e <- [explainPixel traced x y]
      ]

-- | The greatest difference of two lights' amounts.
distant :: Radiance -> Radiance -> Double
distant (Radiance r g b) (Radiance r' g' b') = maximum (map abs [r - r', g - g', b - b'])
