-- | The pictures that a page shows: small ones while something moves, then larger ones,
-- and in the end the bytes that @render@ writes.
module BlackHole.Explore.Picture
  ( Renderer (..),
    movingScene,
    drafted,
    undeveloped,
    quickly,
    completed,
    finishedPng,
    thumbnail,
  )
where

import BlackHole.Image.Coding
import BlackHole.Image.Jpeg
import BlackHole.Image.Metadata
import BlackHole.Image.Write
import BlackHole.Light.Display (ToneMap (..))
import BlackHole.Light.Dither (Dither (..))
import BlackHole.Render.Exposed
import BlackHole.Render.Film
import BlackHole.Render.Optics
import BlackHole.Render.PixelArray
import BlackHole.Render.PixelShape
import BlackHole.Render.Shared (mapShared)
import BlackHole.Render.Workers
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Scene
import BlackHole.Trace.EnvironmentMap (EnvironmentMap)
import BlackHole.Trace.Tracer
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.Vector.Storable as Vector

-- | What all pictures share.
data Renderer = Renderer
  { rendererWorkers :: !Workers,
    -- | The environment map of a scene, if it needs one, or one line that says what is
    -- wrong with it.
    rendererSky :: Scene -> IO (Either String (Maybe EnvironmentMap)),
    -- | Why a scene's picture does not fit into memory, if it does not.
    rendererRoom :: Format -> Scene -> IO (Maybe String)
  }

-- | A scene at a size, with as few rays as show it: neighbouring pixels share them, and few
-- get more. The table of light paths shows the paths of the other integrators, and far
-- sooner. One ray through a wide lens would show noise.
movingScene :: Picture -> Scene -> Scene
movingScene size scene =
  scene
    { scenePicture = size,
      sceneSamples = 1,
      sceneNoise = 0.2,
      sceneMostSamples = 4,
      sceneIntegrator = Tabulated,
      sceneAperture = 0
    }

-- | The film of a scene, with the tracer that made it. Takes over the tables of an
-- earlier tracer where they are equal ('tracerAfter').
drafted :: Renderer -> Maybe EnvironmentMap -> Maybe Tracer -> Scene -> IO (Maybe (Tracer, Film))
drafted renderer sky before scene =
  case maybe (tracerWithSky sky scene) (\earlier -> tracerAfter earlier sky scene) before of
    Nothing -> pure Nothing
    Just traced ->
      fmap ((,) traced . exposedLight)
        <$> exposeTraced
          traced
          (rendererWorkers renderer)
          (const (pure ()))
          (0, pictureHeight (scenePicture scene))

-- | A scene without what only the development of its film depends on. The exposure is
-- kept: it decides which pixels get more rays.
undeveloped :: Scene -> Scene
undeveloped scene =
  scene
    { sceneToneMap = ToneNone,
      sceneDither = NoDither,
      sceneBeam = 0,
      sceneBloom = 0,
      sceneSpikes = 0,
      sceneSpikeLight = 0,
      sceneGrain = 0,
      sceneScaleBar = 0
    }

-- | A film developed for a scene as a JPEG of a quality.
quickly :: Renderer -> Int -> Scene -> Film -> IO Lazy.ByteString
quickly renderer quality scene film = do
  recorded <- opticsFilm workers scene film
  codes <- developFilm workers (sceneDevelopment scene) recorded
  pure (encodeJpeg quality (Metadata software defaultCoding Bytes.empty) codes)
  where
    -- Workers that wait for each other take longer than the work on a small picture,
    -- above all where other programs want the processors too.
    workers
      | shapeLength (pixelArrayShape film) < 400000 = oneWorker
      | otherwise = rendererWorkers renderer

-- | The film of a scene with its own sampling, and the numbers of samples of its pixels.
-- After each band of rows the callback receives the finished fraction and the picture so
-- far: the finished rows, and below them those of an earlier film of the same size.
-- Every number equals that of 'exposeFilm'.
completed ::
  Renderer ->
  Maybe EnvironmentMap ->
  Scene ->
  Film ->
  (Double -> Film -> IO ()) ->
  IO (Maybe Exposed)
completed renderer sky scene earlier progress =
  case (tracerWithSky sky scene, pixelShape width height 3, pixelShape width height 1) of
    (Just traced, Just shape, Just countShape) -> do
      _ <- mapShared workers pure (tracerTables traced)
      let go _ [] done = pure (assemble shape countShape (reverse done))
          go finished ((first, count) : rest) done = do
            band <- exposeTraced traced workers (const (pure ())) (first, count)
            case band of
              Nothing -> pure Nothing
              Just exposed -> do
                let finished' = finished ++ [toPixelVector (exposedLight exposed)]
                    rows = first + count
                    below = Vector.drop (rows * shapeRowLength shape) (toPixelVector earlier)
                mapM_
                  (progress (fromIntegral rows / fromIntegral height))
                  (fromPixelVector shape (Vector.concat (finished' ++ [below])))
                go finished' rest (exposed : done)
      go [] bands []
    _ -> pure Nothing
  where
    workers = rendererWorkers renderer
    Picture width height = scenePicture scene
    bandRows = max (4 * workersCount workers) ((height + 15) `quot` 16)
    bands = [(from, min bandRows (height - from)) | from <- [0, bandRows .. height - 1]]
    assemble shape countShape done = do
      light <- fromPixelVector shape (Vector.concat (map (toPixelVector . exposedLight) done))
      counts <-
        traverse (fmap toPixelVector . exposedCounts) done
          `orNothing` (fromPixelVector countShape . Vector.concat)
      pure (Exposed light counts)
    -- Without numbers, every pixel has the scene's.
    orNothing Nothing _ = Just Nothing
    orNothing (Just parts) use = Just <$> use parts

-- | The PNG file of a film: the bytes that @render@ writes.
finishedPng :: Renderer -> Scene -> Exposed -> IO (Maybe Lazy.ByteString)
finishedPng renderer scene =
  pictureBytes (rendererWorkers renderer) software Png defaultCoding (scene :| [])

-- | A small JPEG of a scene, 240 pixels wide, with one worker.
thumbnail :: Renderer -> Scene -> IO (Maybe Lazy.ByteString)
thumbnail renderer scene = do
  film <- drafted alone Nothing Nothing small
  traverse (quickly alone 85 small . snd) film
  where
    alone = renderer {rendererWorkers = oneWorker}
    Picture width height = scenePicture scene
    small = movingScene (Picture 240 (max 1 ((240 * height) `quot` max 1 width))) scene
