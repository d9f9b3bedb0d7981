-- | Runs every specification and counts them in one closing line:
-- @N passed, N failed@, and @, N skipped@ if any are pending.
module Main (main) where

import Control.Concurrent (forkIO, threadDelay)
import Control.Exception (SomeException, fromException, throwIO, try)
import Control.Monad (forever, when)
import Data.IORef
import qualified Spec
import System.Exit (ExitCode (..), exitWith)
import System.IO
import Test.Hspec.Core.Runner (Summary (..), defaultConfig, hspecWithResult)
import Test.Hspec.Core.Spec (Item (..), Result (..), ResultStatus (..), Spec, mapSpecItem_)

main :: IO ()
main = do
  -- A pipe shows each line soon after it comes, like a terminal. hspec sets the
  -- buffering as it likes.
  _ <- forkIO (forever (threadDelay 200000 >> hFlush stdout))
  pending <- newIORef 0
  outcome <- try (hspecWithResult defaultConfig (countingPending pending Spec.spec))
  case outcome of
    Right (Summary examples failures) -> do
      skipped <- readIORef pending
      -- On a terminal hspec ends with control codes in a line of their own.
      terminal <- hIsTerminalDevice stdout
      when terminal (putStrLn "")
      close (examples - failures - skipped) failures skipped
      exitWith (if failures == 0 then ExitSuccess else ExitFailure 1)
    Left problem
      -- What --help ends with.
      | fromException problem == Just ExitSuccess -> pure ()
      | otherwise -> close 0 1 0 >> throwIO (problem :: SomeException)
  where
    close :: Int -> Int -> Int -> IO ()
    close passed failed skipped =
      putStrLn
        ( show passed ++ " passed, " ++ show failed ++ " failed"
            ++ if skipped > 0 then ", " ++ show skipped ++ " skipped" else ""
        )

-- | hspec's summary does not tell pending examples from passed ones.
countingPending :: IORef Int -> Spec -> Spec
countingPending pending = mapSpecItem_ $ \item ->
  item
    { itemExample = \parameters hook progress -> do
        result <- itemExample item parameters hook progress
        case resultStatus result of
          Pending _ _ -> atomicModifyIORef' pending (\n -> (n + 1, ()))
          _ -> pure ()
        pure result
    }
