{-# LANGUAGE TemplateHaskell #-}

-- | The files of @data\/sky@, which become part of the program when it is compiled:
-- an installed program is one file and works wherever it is moved.
--
-- @data\/sky\/README.md@ describes their formats and names their sources.
module BlackHole.Trace.SkyFiles
  ( starBytes,
    milkyWayBytes,
  )
where

import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Internal as Bytes (toForeignPtr)
import qualified Data.ByteString.Unsafe as Bytes (unsafePackAddressLen)
import Language.Haskell.TH
import Language.Haskell.TH.Syntax (addDependentFile)
import System.IO.Unsafe (unsafePerformIO)

-- | The star catalogue, @data\/sky\/stars.bin@.
starBytes :: Bytes.ByteString
starBytes = fst embedded

-- | The map of the diffuse light, @data\/sky\/milkyway.bin@.
milkyWayBytes :: Bytes.ByteString
milkyWayBytes = snd embedded

-- | Both files. Cabal and Stack run the compiler in the package's root.
embedded :: (Bytes.ByteString, Bytes.ByteString)
embedded =
  $( let file path = do
           addDependentFile path
           bytes <- runIO (Bytes.readFile path)
           let (pointer, offset, size) = Bytes.toForeignPtr bytes
               literal = bytesPrimL (mkBytes pointer (fromIntegral offset) (fromIntegral size))
           -- Safe: the literal has this length, and nothing writes to it.
           [|unsafePerformIO (Bytes.unsafePackAddressLen size $(litE literal))|]
      in tupE [file "data/sky/stars.bin", file "data/sky/milkyway.bin"]
   )
{-# NOINLINE embedded #-}
