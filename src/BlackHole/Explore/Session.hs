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
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Scene.Idle
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
      refuse input = deliver . TextMessage . stateText state . Refused (Just input) . pure
      view =
        View (stateRenderer state) wanted sent drawn (deliver . BinaryMessage . frameBytes) refuse
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
    w <- readTVar (viewWanted (pageView page))
    unless (wantedWindow w == Just (width, height)) $
      writeTVar
        (viewWanted (pageView page))
        w {wantedTurn = wantedTurn w + 1, wantedWindow = Just (width, height)}
  Drawn latest ->
    atomically
      ( readTVar (viewSent (pageView page)) >>= \sent ->
          modifyTVar' (viewDrawn (pageView page)) (max (min sent latest))
      )
  Change input settings -> do
    forbidden <- filterM (fmap not . allowed) [file | Setting _ (FileValue file) <- settings]
    scene <- wantedScene <$> readTVarIO (viewWanted (pageView page))
    let changed = applySettings settings scene
        lost = [s | s <- settings, not (holds changed s)]
        reasons = [renderIdle InFile idle | idle <- idleSettings scene settings]
        problems =
          [ "'" ++ file ++ "' is not in the folder in which blackhole explore was started"
            | file <- forbidden
          ]
            ++ (if null forbidden then map renderProblem (validateScene changed) else [])
    if null problems
      then do
        if null lost
          then show' input changed
          else
            refuse
              input
              (if null reasons then ["these settings have no effect in this scene"] else reasons)
      else refuse input problems
  Restore input preset settings -> do
    forbidden <- filterM (fmap not . allowed) [file | Setting _ (FileValue file) <- settings]
    case findPreset preset of
      Just base
        | null forbidden,
          restored <- applySettings settings base,
          null (validateScene restored) ->
          showFrom preset input restored
      _ -> refuse input ["this is not a scene"]
  LoadPreset input preset -> case findPreset preset of
    Just scene -> showFrom preset input scene
    Nothing -> refuse input ["there is no preset of that name"]
  Steer input how -> do
    scene <- wantedScene <$> readTVarIO (viewWanted (pageView page))
    show' input (steer how scene)
  Inspect across down -> do
    scene <- wantedScene <$> readTVarIO (viewWanted (pageView page))
    before <- atomically (swapTVar (pageInspector page) Nothing)
    mapM_ cancel before
    running <- async (guarded (inspect scene across down))
    atomically (writeTVar (pageInspector page) (Just running))
  AskCommand -> do
    w <- readTVarIO (viewWanted (pageView page))
    tell page (CommandIs (commandLine (wantedPreset w) (wantedScene w)))
  SaveScene how name -> do
    scene <- wantedScene <$> readTVarIO (viewWanted (pageView page))
    save [".yaml", ".yml"] how name (printScene ["A complete scene, with every setting."] scene)
  DefineAnimation timeline -> do
    let made = sequenceOf timeline
    atomically (writeTVar (pageAnimation page) (either (const Nothing) Just made))
    tell page (AnimationIs (sequenceFixed <$> made))
  SaveAnimation how name -> do
    animation <- readTVarIO (pageAnimation page)
    case animation of
      Nothing -> refusal ["there is no animation to save"]
      Just made -> save [".yaml", ".yml"] how name (sequenceText made)
  Scrub input seconds -> do
    animation <- readTVarIO (pageAnimation page)
    case animation of
      Nothing -> refuse input ["there is no animation"]
      Just made ->
        either
          (refuse input . map renderProblem)
          (show' input)
          (sceneAt (sequenceAnimation made) seconds)
  RenderFile how name -> do
    scene <- wantedScene <$> readTVarIO (viewWanted (pageView page))
    ready <- writableFile (map fst formatExtensions) how name
    case (ready, formatOf name) of
      (Left fault, _) -> refusal [fault]
      (Right False, _) -> tell page (Exists name)
      (Right True, Nothing) -> refusal ["'" ++ name ++ "' is not the name of a picture"]
      (Right True, Just format) -> do
        started <- startJob (pageState page) scene format name
        unless started $ refusal ["another picture is being rendered; cancel it first"]
  CancelRender -> readTVarIO (stateWorker (pageState page)) >>= mapM_ cancel
  where
    refuse input = tell page . Refused (Just input)
    refusal = tell page . Refused Nothing
    holds scene s = (findField (settingPath s) >>= (`fieldGet` scene)) == Just (settingValue s)
    -- The files of the scene that the program was started with are the user's choice.
    allowed file
      | neededPicture (snd (stateStart (pageState page))) == Just file = pure True
      | otherwise = readableFile file
    show' input scene =
      atomically
        ( modifyTVar'
            (viewWanted (pageView page))
            (\w -> w {wantedTurn = wantedTurn w + 1, wantedInput = input, wantedScene = scene})
        )
    showFrom preset input scene =
      atomically
        ( modifyTVar'
            (viewWanted (pageView page))
            ( \w ->
                w
                  { wantedTurn = wantedTurn w + 1,
                    wantedInput = input,
                    wantedPreset = preset,
                    wantedScene = scene
                  }
            )
        )
    save extensions how name text = do
      ready <- writableFile extensions how name
      case ready of
        Left fault -> refusal [fault]
        Right False -> tell page (Exists name)
        Right True -> do
          written <- writeFileAtomically name (Builder.toLazyByteString (Builder.stringUtf8 text))
          either (refusal . pure . renderWriteProblem) (const (tell page (Saved name))) written
    guarded action = do
      outcome <- try action
      case outcome of
        Left failure
          | Just (SomeAsyncException _) <- fromException failure ->
            throwIO (failure :: SomeException)
          | otherwise -> refusal [unwords (lines (displayException failure))]
        Right () -> pure ()
    inspect scene across down = do
      sky <- rendererSky (stateRenderer (pageState page)) scene
      let Picture width height = scenePicture scene
          x = min (width - 1) (floor (across * fromIntegral width))
          y = min (height - 1) (floor (down * fromIntegral height))
      case sky of
        Left problem -> refusal [problem]
        Right picture -> case tracerWithSky picture scene >>= \traced ->
          (,) traced <$> explainPixel traced x y of
          Nothing -> refusal ["the pixel cannot be explained"]
          Just (traced, explanation) ->
            tell
              page
              ( PixelIs
                  scene
                  explanation
                  (sightPath traced 40 (XY (fromIntegral x + 0.5) (fromIntegral y + 0.5)))
              )
