-- | Programs from elsewhere that read what this one writes.
module Support.Tool (withTool, withImageMagick, toolOutput, toolOutputIfThere) where

import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Characters
import System.Directory (findExecutable)
import System.IO (hClose, openBinaryTempFile)
import System.IO.Temp (withSystemTempDirectory)
import System.Process (StdStream (..), createProcess, proc, std_err, std_out, waitForProcess)
import Test.Hspec

-- | Do something with a program's path, or call the test pending.
withTool :: String -> (FilePath -> Expectation) -> Expectation
withTool name action =
  findExecutable name >>= maybe (pendingWith (name ++ " is not installed")) action

-- | Pass a function that calls one of ImageMagick's tools, such as @convert@ or
-- @identify@, or mark the test as pending. ImageMagick 7 has them as @magick convert@;
-- other programs of the same names do not count.
withImageMagick :: String -> (([String] -> IO Bytes.ByteString) -> Expectation) -> Expectation
withImageMagick name action = go [("magick", [name]), (name, [])]
  where
    go [] = pendingWith ("ImageMagick's " ++ name ++ " is not installed")
    go ((program, subcommand) : others) = do
      found <- findExecutable program
      version <- maybe (pure Bytes.empty) (`toolOutput` ["-version"]) found
      case found of
        Just path
          | Characters.pack "ImageMagick" `Bytes.isInfixOf` version ->
            action (toolOutput path . (subcommand ++))
        _ -> go others

-- | What a program prints on standard output.
toolOutput :: FilePath -> [String] -> IO Bytes.ByteString
toolOutput program arguments = withSystemTempDirectory "blackhole-tool" $ \folder -> do
  (path, handle) <- openBinaryTempFile folder "output"
  (_, _, _, process) <-
    createProcess (proc program arguments) {std_out = UseHandle handle, std_err = NoStream}
  _ <- waitForProcess process
  hClose handle
  Bytes.readFile path

-- | The same if there is such a program.
toolOutputIfThere :: String -> [String] -> IO (Maybe Bytes.ByteString)
toolOutputIfThere name arguments = findExecutable name >>= traverse (`toolOutput` arguments)
