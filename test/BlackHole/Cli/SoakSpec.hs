module BlackHole.Cli.SoakSpec (spec) where

import Control.Exception (IOException, try)
import Control.Monad (replicateM_)
import Data.Char (isDigit)
import Data.List (isPrefixOf)
import Support.Program (quietly)
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import System.Mem (performMajorGC)
import Test.Hspec

spec :: Spec
spec =
  it "500 renders in one process take no more memory than 100" $
    withSystemTempDirectory "blackhole-spec" $ \folder -> do
      let once =
            quietly
              [ "render",
                "--width",
                "8",
                "--samples",
                "1",
                "--sky",
                "uniform",
                "--no-disk",
                "--integrator",
                "exact",
                "--quiet",
                "-o",
                folder </> "a.png"
              ]
              `shouldReturn` ExitSuccess
      replicateM_ 100 once
      early <- residentKilobytes
      replicateM_ 400 once
      late <- residentKilobytes
      (-) <$> late <*> early `shouldSatisfy` maybe True (< 8192)

-- | What the process has in memory, where the system tells it.
residentKilobytes :: IO (Maybe Int)
residentKilobytes = do
  performMajorGC
  status <- try (readFile "/proc/self/status") :: IO (Either IOException String)
  pure $ case [ read digits
                | line <- either (const []) lines status,
                  "VmRSS:" `isPrefixOf` line,
                  digits@(_ : _) <- [filter isDigit line]
              ] of
    kilobytes : _ -> Just kilobytes
    [] -> Nothing
