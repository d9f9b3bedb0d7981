{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- | @blackhole explore@: a live view in the browser.
module BlackHole.Cli.Explore.Explore
  ( explore,
    service,
  )
where

import BlackHole.Cli.Check (checkThreads)
import BlackHole.Cli.Console (printText, say)
import BlackHole.Cli.ExitStatus
import BlackHole.Cli.Explore.Options
import BlackHole.Cli.ExploreJson
import BlackHole.Cli.Json
import BlackHole.Cli.Memory
import BlackHole.Cli.SceneOptions
import BlackHole.Explore.Access
import BlackHole.Explore.PageFiles
import BlackHole.Explore.Picture
import BlackHole.Explore.Server
import BlackHole.Explore.ServerState
import BlackHole.Explore.Service
import BlackHole.Explore.Session
import BlackHole.Image.SkyFile
import BlackHole.Render.Workers
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Problem
import BlackHole.Scene.Scene
import Control.Concurrent.Async (cancel, race)
import Control.Concurrent.STM
import Control.Exception (IOException, finally, try)
import Control.Monad (unless, void, when)
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import Data.Maybe (fromMaybe)
import System.Directory (findExecutable)
import System.Environment (lookupEnv)
import System.Info (os)
import System.Process (CreateProcess (..), StdStream (NoStream), createProcess, proc)

-- | Runs the server.
explore :: ExploreOptions -> IO ExitStatus
explore options = case serve of
  Nothing ->
    complain
      CannotWrite
      "explore: this program is built without the live view; \
      \script/blackhole explore in a checkout builds it, as does the Cabal flag explore (blackhole \
      \render --preview draws in the terminal)"
  Just server
    | problem : problems <- portProblems ++ checkThreads (exploreThreads options) ->
      complainAll UsageError (problem : problems)
    | otherwise -> do
      loaded <- loadScene (exploreScene options)
      sky <- either (const (pure (Right Nothing))) loadSky loaded
      case (loaded, sky) of
        (Left problems, _) -> BadInput <$ mapM_ say problems
        (_, Left problem) -> complain BadInput problem
        (Right scene, _) -> do
          workers <- maybe defaultWorkers pure (workersFromCount =<< exploreThreads options)
          withWorkers workers (serving server (Renderer workers skyOf room) scene)
  where
    portProblems =
      [ Problem "--port" (show n) "a port from 1 to 65535"
        | Just n <- [explorePort options],
          n < 1 || n > 65535
      ]
    skyOf = fmap (fmap (fmap skyFileImage)) . loadSky
    room format scene =
      memoryProblem
        (Making (WholePicture format) False False)
        scene
        (pictureHeight (scenePicture scene))
    preset = fromMaybe "default" (scenePreset (exploreScene options))
    serving server renderer scene = do
      state <-
        newServerState
          renderer
          (preset, scene)
          (Builder.toLazyByteString . Builder.stringUtf8 . renderJson . replyJson)
      token <- newToken
      let access = Access token
          table = Builder.toLazyByteString (Builder.stringUtf8 (renderJson tableJson))
          announce port = do
            let address = pageAddress (access port)
            _ <- printText ("Open " ++ address ++ " in a browser. Ctrl-C ends the program.\n")
            unless (exploreNoOpen options) (openPage port address)
      -- A picture that is being rendered leaves nothing behind.
      ended <-
        race
          (server (explorePort options) (\port -> service (access port) state table) announce)
          (if exploreKeep options then atomically retry else deserted state)
          `finally` (readTVarIO (stateWorker state) >>= mapM_ cancel)
      case ended of
        Left (Left reason) ->
          complain
            CannotWrite
            ( "explore: cannot listen on port " ++ maybe "of its own" show (explorePort options)
                ++ ": "
                ++ reason
            )
        _ -> pure Done

-- | Returns half a minute after the last page was closed.
deserted :: ServerState -> IO ()
deserted state = do
  atomically (busy state >>= check)
  atomically (busy state >>= check . not)
  late <- registerDelay 30000000
  again <-
    atomically ((True <$ (busy state >>= check)) `orElse` (False <$ (readTVar late >>= check)))
  when again (deserted state)

-- | Open a page in the user's browser, or say how to reach its port from another machine.
openPage :: Int -> String -> IO ()
openPage port address =
  browser >>= \case
    Nothing ->
      say
        ( "no browser here; from another machine, run ssh -L " ++ show port
            ++ ":127.0.0.1:"
            ++ show port
            ++ " with this one's name and open the address there (without a browser: \
               \blackhole render --preview)"
        )
    Just program -> do
      outcome <-
        try . void . createProcess $
          (proc program [address])
            { std_in = NoStream,
              std_out = NoStream,
              std_err = NoStream,
              close_fds = True,
              new_session = True
            }
      either
        (\failure -> say ("cannot run " ++ program ++ ": " ++ show (failure :: IOException)))
        pure
        outcome

-- | The program that opens an address in the user's browser, if there is a display.
browser :: IO (Maybe FilePath)
browser
  | os == "darwin" = findExecutable "open"
  | otherwise = do
    displays <- mapM lookupEnv ["DISPLAY", "WAYLAND_DISPLAY"]
    if any (maybe False (not . null)) displays then findExecutable "xdg-open" else pure Nothing

-- | What the server serves to those who know the token: the page, the table of settings,
-- and pictures of the presets; and the connection.
service :: Access -> ServerState -> Lazy.ByteString -> Service
service access state table =
  Service
    { serviceAnswer = \asked -> case admitted access asked of
        Left refusal -> pure refusal
        Right "table.json" -> pure (Content "application/json" table)
        Right path
          | (kind, contents) : _ <- [(k, c) | (name, k, c) <- pageFiles, name == path] ->
            pure (Content kind (Lazy.fromStrict contents))
          | Just name <- Char8.stripPrefix "preset/" path >>= Char8.stripSuffix ".jpg" ->
            maybe Missing (Content "image/jpeg") <$> presetThumbnail state (Char8.unpack name)
          | otherwise -> pure Missing,
      serviceTalk =
        \asked -> if admittedTalk access asked then Just (serveSession state) else Nothing
    }
