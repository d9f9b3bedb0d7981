-- | Progressive refinement of the picture in a page's view.
--
-- Only the newest scene counts. It appears immediately with few pixels; without further input
-- the picture is refined, and new input stops that in the middle of a row. A page that
-- does not acknowledge its frames gets no more of them, so that none pile up.
module BlackHole.Explore.Refinement
  ( Wanted (..),
    View (..),
    showRefined,
    fitting,
    enlarged,
  )
where

import BlackHole.Explore.Message (Input)
import BlackHole.Explore.Pace
import BlackHole.Explore.Picture
import BlackHole.Explore.Reply
import BlackHole.Light.Display (Exposure (..))
import BlackHole.Render.Exposed
import BlackHole.Render.PixelArray
import BlackHole.Render.PixelShape
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Scene
import BlackHole.Trace.EnvironmentMap (EnvironmentMap)
import BlackHole.Trace.Sky (neededPicture)
import BlackHole.Trace.Tracer
import Control.Concurrent (threadDelay)
import Control.Concurrent.Async
import Control.Concurrent.STM
import Control.Monad (forM_, when)
import qualified Data.ByteString.Lazy as Lazy
import Data.Either (fromRight)
import Data.IORef
import Data.Maybe (fromMaybe, isJust)
import qualified Data.Vector.Storable as Vector
import GHC.Clock (getMonotonicTime)

-- | The picture that a page asks for.
data Wanted = Wanted
  { -- | Grows with every change.
    wantedTurn :: !Int,
    wantedInput :: !Input,
    wantedPreset :: !String,
    wantedScene :: !Scene,
    -- | The view's size, once the page has told it.
    wantedWindow :: !(Maybe (Int, Int))
  }

-- | The view of a page.
data View = View
  { viewRenderer :: !Renderer,
    viewWanted :: !(TVar Wanted),
    -- | The numbers of the latest frame that was sent and that the page has drawn.
    viewSent :: !(TVar Int),
    viewDrawn :: !(TVar Int),
    viewShow :: Frame -> IO (),
    -- | Say why there is no picture of an input.
    viewRefuse :: Input -> String -> IO ()
  }

-- | What is kept from picture to picture.
data Memory = Memory
  { -- | The environment map and the file that it comes from.
    memorySky :: !(Maybe (FilePath, EnvironmentMap)),
    memoryTracer :: !(Maybe Tracer),
    -- | The latest finished picture: its scene and its film.
    memoryFinished :: !(Maybe (Scene, Exposed)),
    memoryPace :: !Pace
  }

-- | Shows the wanted scene and refines it, forever.
showRefined :: View -> IO ()
showRefined view = go (Memory Nothing Nothing Nothing initialPace) (-1)
  where
    go memory done = do
      wanted <- atomically $ do
        w <- readTVar (viewWanted view)
        check (wantedTurn w /= done && isJust (wantedWindow w))
        roomForFrame view
        pure w
      let window =
            maybe (Picture 1 1) (fitting (scenePicture (wantedScene wanted))) (wantedWindow wanted)
          scene = (wantedScene wanted) {scenePicture = window}
      loaded <- skyFor view memory scene
      case loaded of
        Left problem ->
          viewRefuse view (wantedInput wanted) problem >> go memory (wantedTurn wanted)
        Right (sky, memory') -> do
          drawn <- draft view sky memory' (wantedInput wanted) scene
          case drawn of
            Nothing ->
              viewRefuse view (wantedInput wanted) "the scene cannot be traced"
                >> go memory' (wantedTurn wanted)
            Just (memory'', film) -> do
              outcome <-
                race
                  (superseded view wanted)
                  ( threadDelay restMicroseconds
                      >> refine view sky memory'' (wantedInput wanted) scene film
                  )
              go (fromRight memory'' outcome) (wantedTurn wanted)

-- | Returns once something else is wanted.
superseded :: View -> Wanted -> IO ()
superseded view wanted = atomically $ do
  w <- readTVar (viewWanted view)
  check (wantedTurn w /= wantedTurn wanted)

-- | Waits until at most one frame is under way.
roomForFrame :: View -> STM ()
roomForFrame view = do
  sent <- readTVar (viewSent view)
  drawn <- readTVar (viewDrawn view)
  check (sent - drawn < 2)

-- | The scene's environment map, if it needs one, and what to remember of it.
skyFor :: View -> Memory -> Scene -> IO (Either String (Maybe EnvironmentMap, Memory))
skyFor view memory scene = case (neededPicture scene, memorySky memory) of
  (Nothing, _) -> pure (Right (Nothing, memory))
  (Just file, Just (known, picture)) | file == known -> pure (Right (Just picture, memory))
  (Just file, _) -> do
    loaded <- rendererSky (viewRenderer view) scene
    pure $ case loaded of
      Right (Just picture) ->
        Right
          ( Just picture,
            memory
              { memorySky = Just (file, picture),
                memoryTracer = Nothing,
                memoryFinished = Nothing
              }
          )
      Right Nothing -> Right (Nothing, memory)
      Left problem -> Left problem

-- | A picture at once: the finished one developed anew if that is all that changed.
draft ::
  View -> Maybe EnvironmentMap -> Memory -> Input -> Scene -> IO (Maybe (Memory, Film))
draft view sky memory input scene = case memoryFinished memory of
  Just (finished, exposed) | atExposureZero finished == atExposureZero scene -> do
    picture <- quickly (viewRenderer view) 90 scene (exposedLight exposed)
    deliver view Refining 0 input (scenePicture scene) picture
    pure (Just (memory, exposedLight exposed))
  _ -> do
    start <- getMonotonicTime
    let size@(Picture width height) = movingSize (memoryPace memory) (scenePicture scene)
        moving = movingScene size scene
    drawn <- drafted (viewRenderer view) sky (memoryTracer memory) moving
    case drawn of
      Nothing -> pure Nothing
      Just (traced, film) -> do
        picture <- quickly (viewRenderer view) 80 moving film
        deliver view Moving 0 input size picture
        end <- getMonotonicTime
        pure
          ( Just
              ( memory
                  { memoryTracer = Just traced,
                    memoryPace = paced (width * height) (end - start) (memoryPace memory)
                  },
                film
              )
          )

-- | Shows ever better pictures up to the finished one.
refine :: View -> Maybe EnvironmentMap -> Memory -> Input -> Scene -> Film -> IO Memory
refine view sky memory input scene film = case memoryFinished memory of
  Just (finished, exposed)
    | undeveloped finished == undeveloped scene ->
      finish view memory input scene exposed
  _ -> do
    sharper <- enlarging view sky (memoryTracer memory) input scene film
    latest <- getMonotonicTime >>= newIORef
    exposed <- completed (viewRenderer view) sky scene sharper $ \done so -> do
      now <- getMonotonicTime
      before <- readIORef latest
      free <- atomically ((True <$ roomForFrame view) `orElse` pure False)
      when (free && now - before > 0.25 && done < 1) $ do
        picture <- quickly (viewRenderer view) 92 scene so
        deliver view Refining done input (scenePicture scene) picture
        getMonotonicTime >>= writeIORef latest
    maybe (pure memory) (finish view memory input scene) exposed

finish :: View -> Memory -> Input -> Scene -> Exposed -> IO Memory
finish view memory input scene exposed = do
  bytes <- finishedPng (viewRenderer view) scene exposed
  atomically (roomForFrame view)
  forM_ bytes $ \png -> deliver view Finished 1 input (scenePicture scene) png
  pure memory {memoryFinished = Just (scene, exposed)}

-- | The sampling of 'movingScene', with twice as many rows each time, up to the window's
-- size.
enlarging ::
  View -> Maybe EnvironmentMap -> Maybe Tracer -> Input -> Scene -> Film -> IO Film
enlarging view sky traced input scene film
  | size == scenePicture scene = pure film
  -- The final picture itself has this sampling.
  | next == scenePicture scene && movingScene next scene == scene = pure (enlarged film next)
  | otherwise = do
    drawn <- drafted (viewRenderer view) sky traced (movingScene next scene)
    case drawn of
      Nothing -> pure (enlarged film (scenePicture scene))
      Just (traced', larger) -> do
        picture <- quickly (viewRenderer view) 88 (movingScene next scene) larger
        atomically (roomForFrame view)
        deliver view Refining 0 input next picture
        enlarging view sky (Just traced') input scene larger
  where
    size@(Picture width height) = filmSize film
    Picture most mostRows = scenePicture scene
    next
      | 2 * width >= most = Picture most mostRows
      | otherwise = Picture (2 * width) (max 1 (min mostRows (2 * height)))

-- | Sends a frame with the next number.
deliver :: View -> Stage -> Double -> Input -> Picture -> Lazy.ByteString -> IO ()
deliver view stage done input (Picture width height) picture = do
  number <- atomically $ do
    n <- (+ 1) <$> readTVar (viewSent view)
    n <$ writeTVar (viewSent view) n
  viewShow view (Frame stage done number input (width, height) picture)

-- | How long nothing new must come before the refinement begins, in microseconds.
restMicroseconds :: Int
restMicroseconds = 60000

atExposureZero :: Scene -> Scene
atExposureZero scene = (undeveloped scene) {sceneExposure = Exposure 0}

-- | The largest size of a picture's shape in a window.
fitting :: Picture -> (Int, Int) -> Picture
fitting (Picture width height) (across, down) = Picture (scaled width) (scaled height)
  where
    share =
      min (fromIntegral across / fromIntegral width) (fromIntegral down / fromIntegral height) ::
        Double
    scaled side = max 1 (round (share * fromIntegral side))

filmSize :: Film -> Picture
filmSize film = Picture (shapeWidth (pixelArrayShape film)) (shapeHeight (pixelArrayShape film))

-- | A film at another size, by repeating pixels.
enlarged :: Film -> Picture -> Film
enlarged film (Picture width height) =
  fromMaybe
    film
    (pixelShape width height 3 >>= (`fromPixelVector` Vector.generate (3 * width * height) at))
  where
    Picture width' height' = filmSize film
    light = toPixelVector film
    at i =
      let (pixel, channel) = i `quotRem` 3
          (row, column) = pixel `quotRem` width
       in light
            Vector.! ( 3
                         * ( width' * ((row * height') `quot` height)
                               + (column * width') `quot` width
                           )
                         + channel
                     )
