-- | Programs from elsewhere that read what this one writes.
module Support.Tool (withTool, toolOutput, toolOutputIfThere) where

import qualified Data.ByteString as Bytes
import System.Directory (findExecutable)
import System.IO (hClose, openBinaryTempFile)
import System.IO.Temp (withSystemTempDirectory)
import System.Process (StdStream (..), createProcess, proc, std_err, std_out, waitForProcess)
import Test.Hspec

-- | Do something with a program's path, or call the test pending.
withTool :: String -> (FilePath -> Expectation) -> Expectation
withTool name action =
  findExecutable name >>= maybe (pendingWith (name ++ " is not installed")) action

-- | What a program prints on standard output.
toolOutput :: FilePath -> [String] -> IO Bytes.ByteString
toolOutput program arguments = withSystemTempDirectory "blackhole-tool" $ \folder -> do
  (path, handle) <- openBinaryTempFile folder "output"
  (_, _, _, process) <- createProcess (proc program arguments) {std_out = UseHandle handle, std_err = NoStream}
  _ <- waitForProcess process
  hClose handle
  Bytes.readFile path

-- | The same if there is such a program.
toolOutputIfThere :: String -> [String] -> IO (Maybe Bytes.ByteString)
toolOutputIfThere name arguments = findExecutable name >>= traverse (`toolOutput` arguments)
