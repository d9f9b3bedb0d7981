-- | SHA-256 fingerprints of scenes and files (FIPS 180-4), which @sha256sum@ can check.
module BlackHole.Image.Digest
  ( Digest,
    digestHex,
    parseDigest,
    digestBytes,
    digestText,
    digestFile,
  )
where

import qualified Crypto.Hash.SHA256 as SHA256
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.ByteString.Lazy.Char8 as Char8
import Data.Char (isHexDigit, isUpper)
import System.IO (IOMode (ReadMode), withBinaryFile)

-- | A fingerprint of 64 hexadecimal digits.
newtype Digest = Digest String
  deriving (Eq, Ord, Show)

-- | The digits.
digestHex :: Digest -> String
digestHex (Digest hex) = hex

-- | Parses 64 hexadecimal digits in lower case.
parseDigest :: String -> Maybe Digest
parseDigest text
  | length text == 64 && all digit text = Just (Digest text)
  | otherwise = Nothing
  where
    digit c = isHexDigit c && not (isUpper c)

-- | The fingerprint of bytes, in linear time and constant memory.
digestBytes :: Lazy.ByteString -> Digest
digestBytes = hexadecimal . SHA256.hashlazy

-- | The fingerprint of a text in UTF-8.
digestText :: String -> Digest
digestText = digestBytes . Builder.toLazyByteString . Builder.stringUtf8

-- | The fingerprint of a file, and its size in bytes. Throws the exceptions of the file
-- system.
digestFile :: FilePath -> IO (Digest, Integer)
digestFile path = withBinaryFile path ReadMode (go SHA256.init 0)
  where
    go context size handle = do
      chunk <- Bytes.hGetSome handle 65536
      if Bytes.null chunk
        then pure (hexadecimal (SHA256.finalize context), size)
        else do
          let next = SHA256.update context chunk
              total = size + toInteger (Bytes.length chunk)
          next `seq` total `seq` go next total handle

hexadecimal :: Bytes.ByteString -> Digest
hexadecimal = Digest . Char8.unpack . Builder.toLazyByteString . Builder.byteStringHex
