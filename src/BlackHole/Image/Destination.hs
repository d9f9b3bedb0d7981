-- | Destinations for the bytes of a picture file. Encoders write a file from its first
-- byte to its last, so that no large picture need be in memory as a whole.
module BlackHole.Image.Destination
  ( Destination (..),
    toHandle,
    inMemory,
    Encoder,
  )
where

import BlackHole.Render.Pyramid (FilmBands)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.IORef (modifyIORef', newIORef, readIORef)
import System.IO (Handle, SeekMode (AbsoluteSeek), hIsSeekable, hSeek)

-- | A destination for bytes.
data Destination = Destination
  { -- | Appends bytes.
    putBytes :: !(ByteString -> IO ()),
    -- | Overwrites bytes from a position on, counted from the first byte. Nothing may be
    -- appended afterwards. 'Nothing' if the destination cannot go back.
    overwriteBytes :: !(Maybe (Int -> ByteString -> IO ()))
  }

-- | Writes a film of known size, given by its bands, to a destination. The result is
-- 'False', and the file truncated, as soon as a band is missing.
type Encoder = FilmBands -> Destination -> IO Bool

-- | An empty file, or a pipe, which cannot go back.
toHandle :: Handle -> IO Destination
toHandle handle = do
  seekable <- hIsSeekable handle
  pure (Destination (Bytes.hPut handle) (if seekable then Just overwrite else Nothing))
  where
    overwrite place bytes = hSeek handle AbsoluteSeek (toInteger place) >> Bytes.hPut handle bytes

-- | The result of an action and the bytes that it has written.
inMemory :: (Destination -> IO a) -> IO (a, Lazy.ByteString)
inMemory write = do
  written <- newIORef []
  result <- write (Destination (\bytes -> modifyIORef' written (bytes :)) Nothing)
  (,) result . Lazy.fromChunks . reverse <$> readIORef written
