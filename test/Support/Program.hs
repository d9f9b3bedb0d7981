-- | The program, run inside the tests' process.
module Support.Program (quietly, outputOf, redirecting) where

import BlackHole.Cli.Run (run)
import Control.Exception (bracket_)
import GHC.IO.Handle (hDuplicate, hDuplicateTo)
import System.Exit (ExitCode)
import System.IO

-- | Run the program without reports of progress and success.
quietly :: [String] -> IO ExitCode
quietly arguments =
  run
    ( arguments
        ++ [ "--quiet"
             | take 1 arguments `elem` map pure ["render", "join", "animate", "rays", "photon"]
           ]
    )

-- | Run an action and return its result with what it wrote to a handle, by way of a
-- file.
outputOf :: Handle -> FilePath -> IO a -> IO (a, String)
outputOf handle file action = do
  result <- redirecting handle file action
  text <- withFile file ReadMode $ \source -> do
    hSetEncoding source utf8
    written <- hGetContents source
    written <$ mapM_ (`seq` pure ()) written
  pure (result, text)

-- | Run an action while a handle writes to a file.
redirecting :: Handle -> FilePath -> IO a -> IO a
redirecting handle file action = do
  hFlush handle
  kept <- hDuplicate handle
  withFile file WriteMode $ \sink -> do
    hSetEncoding sink utf8
    bracket_
      (hDuplicateTo sink handle >> hSetEncoding handle utf8)
      (hFlush handle >> hDuplicateTo kept handle)
      action
