-- | Examples that @script/test-scripts@ tells how to end. Otherwise they pass.
module TrialSpec (spec) where

import Control.Concurrent (threadDelay)
import Control.Monad (unless)
import System.Directory (doesFileExist)
import System.Environment (lookupEnv)
import System.Posix.Signals (raiseSignal, sigKILL)
import Test.Hspec

spec :: Spec
spec = do
  it "passes" (pure () :: Expectation)
  it "waits for the file that BLACKHOLE_TRIAL_FILE names" $
    lookupEnv "BLACKHOLE_TRIAL_FILE" >>= mapM_ awaitFile
  it "ends as BLACKHOLE_TRIAL says" $ do
    ending <- lookupEnv "BLACKHOLE_TRIAL"
    case ending of
      Just "fail" -> expectationFailure "as told"
      Just "skip" -> pendingWith "as told"
      Just "die" -> raiseSignal sigKILL
      _ -> pure ()

awaitFile :: FilePath -> IO ()
awaitFile path = do
  there <- doesFileExist path
  unless there (threadDelay 20000 >> awaitFile path)
