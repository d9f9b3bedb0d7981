-- | Standard output and standard error: what the program prints, and what happens
-- if that fails.
--
-- Whatever is printed on standard output is a result, so that its loss is an error.
-- Messages and progress on standard error are not: they are dropped if they cannot be
-- written, and never prevent the work.
module BlackHole.Cli.Console
  ( printText,
    printWith,
    OutputProblem (..),
    outputIsClosed,
    say,
    message,
    tell,
    succeeded,
  )
where

import BlackHole.Image.AtomicFile (printable)
import Control.Exception (IOException, catch, try)
import Control.Monad (void)
import Data.Bits ((.&.))
import GHC.Clock (getMonotonicTime)
import GHC.IO.Exception (IOErrorType (ResourceVanished), IOException (..))
import Numeric (showFFloat)
import System.IO (Handle, hFlush, hPutStr, hSetBinaryMode, stderr, stdout)
import System.Posix.Internals (c_fcntl_read, const_f_getfl, o_RDONLY)
import System.Timeout (timeout)

-- | Why standard output did not take everything.
data OutputProblem
  = -- | Its reader has ended, as @head@ does when it has seen enough.
    ReaderGone
  | -- | Anything else, with the reason that the system gives.
    OutputRefused !String
  deriving (Eq, Show)

-- | Print a text on standard output, to the last byte.
printText :: String -> IO (Either OutputProblem ())
printText text = printing (`hPutStr` text)

-- | Print bytes on standard output by an action that writes to its handle.
printWith :: (Handle -> IO ()) -> IO (Either OutputProblem ())
printWith write = printing (\handle -> hSetBinaryMode handle True >> write handle)

printing :: (Handle -> IO ()) -> IO (Either OutputProblem ())
printing write = either (Left . problem) Right <$> try (write stdout >> hFlush stdout)
  where
    problem failure
      | ioe_type failure == ResourceVanished = ReaderGone
      | otherwise = OutputRefused (ioe_description failure)

-- | Whether standard output is closed, or open for reading only.
outputIsClosed :: IO Bool
outputIsClosed = do
  mode <- c_fcntl_read 1 const_f_getfl
  pure (mode < 0 || mode .&. 3 == o_RDONLY)

-- | A message of one line on standard error, after the program's name.
say :: String -> IO ()
say line = message ("blackhole: " ++ printable line ++ "\n")

-- | A text on standard error, as it is. Waits at most a second for a reader.
message :: String -> IO ()
message = tellWithin 1000000

-- | Progress on standard error, as it is. Takes at most some 10 ms, also if standard
-- error is a pipe whose reader does not read. On a busy machine it may be lost, which
-- does no harm to a text that the next one replaces.
tell :: String -> IO ()
tell = tellWithin 10000

-- | Reports success on standard error: a file, its content, and the seconds since the
-- start, as in @hole.png: 640 × 360, 1.3 s@.
succeeded :: Double -> FilePath -> String -> IO ()
succeeded start file content = do
  end <- getMonotonicTime
  message
    ( printable
        ( (if file == "-" then "standard output" else file) ++ ": " ++ content ++ ", "
            ++ showFFloat (Just 1) (end - start) " s"
        )
        ++ "\n"
    )

-- A write to a full pipe waits until it has room, which can be interrupted.
tellWithin :: Int -> String -> IO ()
tellWithin microseconds text =
  void (timeout microseconds (hPutStr stderr text >> hFlush stderr))
    `catch` dropped
  where
    dropped :: IOException -> IO ()
    dropped _ = pure ()
