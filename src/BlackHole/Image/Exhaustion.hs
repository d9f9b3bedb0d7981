-- | What happens when memory runs out.
--
-- The program estimates its memory before it starts (@BlackHole.Cli.Memory@), but other
-- processes may take what was free. GHC's run-time system then ends the process without
-- running any handler in Haskell, so this is written in C
-- (@src\/BlackHole\/Image\/Exhaustion.c@).
module BlackHole.Image.Exhaustion
  ( handleExhaustion,
    removeIfExhausted,
    keepIfExhausted,
  )
where

import Foreign.C (CInt (..), CString)
import System.Exit (ExitCode (..))
import System.Posix.Internals (withFilePath)

-- | From now on, a process that runs out of memory removes the files named by
-- 'removeIfExhausted', says so in one line on standard error, and ends with this exit code.
handleExhaustion :: ExitCode -> IO ()
handleExhaustion code = c_handle $ case code of
  ExitSuccess -> 0
  ExitFailure n -> fromIntegral n

-- | Names a file to remove if memory runs out. At most 1024 at a time; further ones are
-- left behind.
removeIfExhausted :: FilePath -> IO ()
removeIfExhausted path = withFilePath path c_remove

-- | Takes back 'removeIfExhausted', for a file that has been renamed or removed.
keepIfExhausted :: FilePath -> IO ()
keepIfExhausted path = withFilePath path c_keep

foreign import ccall unsafe "blackhole_handle_exhaustion" c_handle :: CInt -> IO ()

foreign import ccall unsafe "blackhole_remove_if_exhausted" c_remove :: CString -> IO ()

foreign import ccall unsafe "blackhole_keep_if_exhausted" c_keep :: CString -> IO ()
