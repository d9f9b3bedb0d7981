{-# LANGUAGE LambdaCase #-}

-- | The connection with one page of @blackhole explore@: what its messages do, and
-- what it is sent.
module BlackHole.Explore.Session
  ( serveSession,
  )
where

import BlackHole.Animation.Animation (sceneAt)
import BlackHole.Explore.CommandLine
import BlackHole.Explore.Files
import BlackHole.Explore.Message
import BlackHole.Explore.Picture
import BlackHole.Explore.Refinement
import BlackHole.Explore.Reply
import BlackHole.Explore.ServerState
import BlackHole.Explore.Service
import BlackHole.Explore.SightPath
import BlackHole.Explore.Steer
import BlackHole.Explore.Timeline
import BlackHole.Image.AtomicFile
import BlackHole.Image.Coding
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Kind
import BlackHole.Scene.Field.Table
import BlackHole.Scene.File.SceneFile
import BlackHole.Scene.Idle
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Scene.Setting
import BlackHole.Scene.Validate
import BlackHole.Trace.Explain
import BlackHole.Trace.Sky (neededPicture)
import BlackHole.Trace.Tracer
import BlackHole.Vector.XY (XY (..))
import Control.Concurrent (threadDelay)
import Control.Concurrent.Async
import Control.Concurrent.MVar
import Control.Concurrent.STM
import Control.Exception
  ( SomeAsyncException (..),
    SomeException,
    bracket_,
    displayException,
    finally,
    fromException,
    throwIO,
    try,
  )
import Control.Monad (filterM, unless)
import qualified Data.ByteString.Builder as Builder

-- | An open page.
data Page = Page
  { pageState :: !ServerState,
    pageView :: !View,
    pageAnimation :: !(TVar (Maybe Sequence)),
    -- | The thread that explains a pixel.
    pageInspector :: !(TVar (Maybe (Async ()))),
    pageSend :: Outgoing -> IO ()
  }

-- | Talk to a page until it is gone.
serveSession :: ServerState -> Connection -> IO ()
serveSession state connection = bracket_ (count 1) (count (-1)) $ do
  lock <- newMVar ()
  wanted <- newTVarIO (uncurry (Wanted 0 0) (stateStart state) Nothing)
  sent <- newTVarIO 0
  drawn <- newTVarIO 0
  animation <- newTVarIO Nothing
  inspector <- newTVarIO Nothing
  let deliver message = withMVar lock (\() -> send connection message)
      refused input = deliver . TextMessage . stateText state . Refused (Just input) . pure
      view =
        View (stateRenderer state) wanted sent drawn (deliver . BinaryMessage . frameBytes) refused
      page = Page state view animation inspector deliver
  let listen =
        hear connection
          >>= mapM_
            ( \bytes ->
                either
                  (\(input, fault) -> tell page (Refused input [fault]))
                  (handleMessage page)
                  (parseMessage bytes)
                  >> listen
            )
  (listen `race_` showRefined view `race_` announce page `race_` reportJob page)
    `finally` (readTVarIO (pageInspector page) >>= mapM_ cancel)
  where
    count n = atomically (modifyTVar' (statePages state) (+ n))

tell :: Page -> Reply -> IO ()
tell page = pageSend page . TextMessage . stateText (pageState page)

-- | Tell the page its scene whenever it has changed, but at most twelve times a second.
announce :: Page -> IO ()
announce page = go (-1)
  where
    go told = do
      wanted <- atomically $ do
        w <- readTVar (viewWanted (pageView page))
        check (wantedTurn w /= told)
        pure w
      tell page (SceneIs (wantedInput wanted) (wantedPreset wanted) (wantedScene wanted))
      threadDelay 80000
      go (wantedTurn wanted)

-- | Tell the page the state of the rendering to a file whenever it has changed, but at
-- most four times a second.
reportJob :: Page -> IO ()
reportJob page = go NoJob
  where
    job = stateJob (pageState page)
    go told = do
      now <- atomically $ do
        j <- readTVar job
        check (j /= told)
        pure j
      tell page (JobIs now)
      threadDelay 250000
      go now

-- | Do what a message says.
handleMessage :: Page -> Message -> IO ()
handleMessage page message = case message of
  Window width height -> atomically $ do
    w <- readTVar wanted
    unless (wantedWindow w == Just (width, height)) $
      writeTVar wanted w {wantedTurn = wantedTurn w + 1, wantedWindow = Just (width, height)}
  Drawn latest -> atomically $ do
    sent <- readTVar (viewSent (pageView page))
    modifyTVar' (viewDrawn (pageView page)) (max (min sent latest))
  Change input settings -> changeSettings page input settings
  Restore input preset settings -> restoreScene page input preset settings
  LoadPreset input preset -> case findPreset preset of
    Just scene -> showFrom preset page input scene
    Nothing -> refuse page input ["there is no preset of that name"]
  Steer input how -> sceneOf page >>= showScene page input . steer how
  Inspect across down -> do
    scene <- sceneOf page
    before <- atomically (swapTVar (pageInspector page) Nothing)
    mapM_ cancel before
    running <- async (guarded page (inspect page scene across down))
    atomically (writeTVar (pageInspector page) (Just running))
  AskCommand -> do
    w <- readTVarIO wanted
    tell page (CommandIs (commandLine (wantedPreset w) (wantedScene w)))
  SaveScene how name -> do
    scene <- sceneOf page
    saveText page how name (printScene ["A complete scene, with every setting."] scene)
  DefineAnimation timeline -> do
    let made = sequenceOf timeline
    atomically (writeTVar (pageAnimation page) (either (const Nothing) Just made))
    tell page (AnimationIs (sequenceFixed <$> made))
  SaveAnimation how name ->
    readTVarIO (pageAnimation page)
      >>= maybe
        (refusal page ["there is no animation to save"])
        (saveText page how name . sequenceText)
  Scrub input seconds ->
    readTVarIO (pageAnimation page) >>= \case
      Nothing -> refuse page input ["there is no animation"]
      Just made ->
        either
          (refuse page input . map renderProblem)
          (showScene page input)
          (sceneAt (sequenceAnimation made) seconds)
  RenderFile how name -> renderPicture page how name
  CancelRender -> readTVarIO (stateWorker (pageState page)) >>= mapM_ cancel
  where
    wanted = viewWanted (pageView page)

-- | Refuse what came with the input of this number, for these reasons.
refuse :: Page -> Input -> [String] -> IO ()
refuse page input = tell page . Refused (Just input)

-- | Refuse what is no input to the scene.
refusal :: Page -> [String] -> IO ()
refusal page = tell page . Refused Nothing

-- | The scene that the page wants to see.
sceneOf :: Page -> IO Scene
sceneOf page = wantedScene <$> readTVarIO (viewWanted (pageView page))

-- | Show a scene, as the input of this number asks.
showScene :: Page -> Input -> Scene -> IO ()
showScene page input scene = want page (\w -> w {wantedInput = input, wantedScene = scene})

-- | 'showScene' for a scene that is based on this preset.
showFrom :: String -> Page -> Input -> Scene -> IO ()
showFrom preset page input scene =
  want page (\w -> w {wantedInput = input, wantedPreset = preset, wantedScene = scene})

want :: Page -> (Wanted -> Wanted) -> IO ()
want page change =
  atomically . modifyTVar' (viewWanted (pageView page)) $ \w ->
    (change w) {wantedTurn = wantedTurn w + 1}

changeSettings :: Page -> Input -> [Setting] -> IO ()
changeSettings page input settings = do
  forbidden <- forbiddenFiles page settings
  scene <- sceneOf page
  let changed = applySettings settings scene
      lost = [s | s <- settings, not (holds changed s)]
      reasons = [renderIdle InFile idle | idle <- idleSettings scene settings]
      problems =
        [ "'" ++ file ++ "' is not in the folder in which blackhole explore was started"
          | file <- forbidden
        ]
          ++ (if null forbidden then map renderProblem (validateScene changed) else [])
      noEffect = ["these settings have no effect in this scene"]
  case problems of
    [] | null lost -> showScene page input changed
    [] -> refuse page input (if null reasons then noEffect else reasons)
    _ -> refuse page input problems
  where
    holds scene s = (findField (settingPath s) >>= (`fieldGet` scene)) == Just (settingValue s)

restoreScene :: Page -> Input -> String -> [Setting] -> IO ()
restoreScene page input preset settings = do
  forbidden <- forbiddenFiles page settings
  case applySettings settings <$> findPreset preset of
    Just restored
      | null forbidden,
        null (validateScene restored) ->
        showFrom preset page input restored
    _ -> refuse page input ["this is not a scene"]

-- | The files in these settings that the page must not read. The files of the scene that
-- the program was started with are the user's choice.
forbiddenFiles :: Page -> [Setting] -> IO [FilePath]
forbiddenFiles page settings =
  filterM (fmap not . allowed) [file | Setting _ (FileValue file) <- settings]
  where
    allowed file
      | neededPicture (snd (stateStart (pageState page))) == Just file = pure True
      | otherwise = readableFile file

renderPicture :: Page -> Overwriting -> FilePath -> IO ()
renderPicture page how name = do
  scene <- sceneOf page
  ready <- writableFile (map fst formatExtensions) how name
  case (ready, formatOf name) of
    (Left fault, _) -> refusal page [fault]
    (Right False, _) -> tell page (Exists name)
    (Right True, Nothing) -> refusal page ["'" ++ name ++ "' is not the name of a picture"]
    (Right True, Just format) -> do
      started <- startJob (pageState page) scene format name
      unless started $ refusal page ["another picture is being rendered; cancel it first"]

-- | Save YAML.
saveText :: Page -> Overwriting -> FilePath -> String -> IO ()
saveText page how name text = do
  ready <- writableFile [".yaml", ".yml"] how name
  case ready of
    Left fault -> refusal page [fault]
    Right False -> tell page (Exists name)
    Right True -> do
      written <- writeFileAtomically name (Builder.toLazyByteString (Builder.stringUtf8 text))
      either (refusal page . pure . renderWriteProblem) (const (tell page (Saved name))) written

-- | Run an action and tell the page of its failure.
guarded :: Page -> IO () -> IO ()
guarded page action =
  try action >>= \case
    Left failure
      | Just (SomeAsyncException _) <- fromException failure -> throwIO (failure :: SomeException)
      | otherwise -> refusal page [unwords (lines (displayException failure))]
    Right () -> pure ()

-- | Explain the pixel at these fractions of the width and height.
inspect :: Page -> Scene -> Double -> Double -> IO ()
inspect page scene across down = do
  sky <- rendererSky (stateRenderer (pageState page)) scene
  let Picture width height = scenePicture scene
      x = min (width - 1) (floor (across * fromIntegral width))
      y = min (height - 1) (floor (down * fromIntegral height))
      explained picture = do
        traced <- tracerWithSky picture scene
        (,) traced <$> explainPixel traced x y
  case explained <$> sky of
    Left problem -> refusal page [problem]
    Right Nothing -> refusal page ["the pixel cannot be explained"]
    Right (Just (traced, explanation)) -> do
      let path = sightPath traced 40 (XY (fromIntegral x + 0.5) (fromIntegral y + 0.5))
      tell page (PixelIs scene explanation path)
