{-# LANGUAGE OverloadedStrings #-}

-- | Access to @blackhole explore@: only for a page that it served itself, to a browser
-- that knows its address.
--
-- The server listens on the loopback interface, but any page in the same browser can
-- send requests there. Three checks keep such pages out. The path of every request
-- begins with a token of 128 random bits. The Host header must name this server, so that
-- a name that an attacker points to 127.0.0.1 does not serve. And the Origin header,
-- which a browser adds to every WebSocket, must be this server's.
module BlackHole.Explore.Access
  ( Access (..),
    newToken,
    pageAddress,
    admitted,
    admittedTalk,
  )
where

import BlackHole.Explore.Service
import Data.Bits (xor, (.|.))
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import System.IO (IOMode (ReadMode), withBinaryFile)

-- | What a request must know.
data Access = Access
  { -- | 32 hexadecimal digits.
    accessToken :: !Bytes.ByteString,
    accessPort :: !Int
  }

-- | A new token from the system's random generator.
newToken :: IO Bytes.ByteString
newToken =
  Lazy.toStrict . Builder.toLazyByteString . Builder.byteStringHex
    <$> withBinaryFile "/dev/urandom" ReadMode (`Bytes.hGet` 16)

-- | The address of the page.
pageAddress :: Access -> String
pageAddress access =
  "http://127.0.0.1:" ++ show (accessPort access) ++ "/" ++ Char8.unpack (accessToken access) ++ "/"

-- | The rest of a request's path behind the token, or why it is refused.
admitted :: Access -> Asked -> Either Answer Bytes.ByteString
admitted access asked
  | not (ownHost access asked) = Left Forbidden
  | maybe False (`notElem` ownOrigins access) (askedOrigin asked) = Left Forbidden
  | Just rest <- behindToken access (askedPath asked) =
    if askedMethod asked `elem` ["GET", "HEAD"] then Right rest else Left WrongMethod
  | otherwise = Left Forbidden

-- | Whether a page may open a WebSocket.
admittedTalk :: Access -> Asked -> Bool
admittedTalk access asked =
  ownHost access asked
    && maybe False (`elem` ownOrigins access) (askedOrigin asked)
    && behindToken access (askedPath asked) == Just "talk"

ownHost :: Access -> Asked -> Bool
ownHost access asked = maybe False (`elem` ownNames access) (askedHost asked)

ownNames :: Access -> [Bytes.ByteString]
ownNames access =
  [name <> ":" <> Char8.pack (show (accessPort access)) | name <- ["127.0.0.1", "localhost"]]

ownOrigins :: Access -> [Bytes.ByteString]
ownOrigins access = map ("http://" <>) (ownNames access)

-- | The path behind @\/TOKEN\/@. The comparison takes equally long for all wrong tokens
-- of the right length.
behindToken :: Access -> Bytes.ByteString -> Maybe Bytes.ByteString
behindToken access path
  | Bytes.length given == Bytes.length token,
    foldr (.|.) 0 (Bytes.zipWith xor given token) == 0 =
    Just rest
  | otherwise = Nothing
  where
    token = "/" <> accessToken access <> "/"
    (given, rest) = Bytes.splitAt (Bytes.length token) path
