{-# LANGUAGE ForeignFunctionInterface #-}

-- | The files of @data\/sky@, which become part of the program when it is compiled:
-- an installed program is one file and works wherever it is moved.
--
-- @data\/sky\/README.md@ describes their formats and names their sources. The assembler
-- includes them (@data\/embedded.c@). Template Haskell could do so as well, but with it
-- GHC compiles every module of the package twice.
module BlackHole.Trace.SkyFiles
  ( starBytes,
    milkyWayBytes,
  )
where

import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Unsafe as Bytes (unsafePackCStringLen)
import Foreign.C.Types (CChar)
import Foreign.Ptr (Ptr)
import System.IO.Unsafe (unsafePerformIO)

foreign import ccall "&blackhole_stars" starsAddress :: Ptr CChar

foreign import ccall "&blackhole_milky_way" milkyWayAddress :: Ptr CChar

-- | The star catalogue, @data\/sky\/stars.bin@.
starBytes :: Bytes.ByteString
starBytes = constant starsAddress 945880
{-# NOINLINE starBytes #-}

-- | The map of the diffuse light, @data\/sky\/milkyway.bin@.
milkyWayBytes :: Bytes.ByteString
milkyWayBytes = constant milkyWayAddress 275400
{-# NOINLINE milkyWayBytes #-}

-- | Constant bytes of a known size, not copied. The tests compare them with the files.
constant :: Ptr CChar -> Int -> Bytes.ByteString
constant address size = unsafePerformIO (Bytes.unsafePackCStringLen (address, size))
