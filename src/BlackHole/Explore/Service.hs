-- | The interface between @blackhole explore@ and its web server, free of any web library.
-- "BlackHole.Explore.Server" implements the server in builds that have one.
module BlackHole.Explore.Service
  ( Asked (..),
    Answer (..),
    Outgoing (..),
    Connection (..),
    Service (..),
    maximumMessageBytes,
  )
where

import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy

-- | A request, as far as it matters here.
data Asked = Asked
  { askedMethod :: !Bytes.ByteString,
    -- | The path with its first slash, without the query.
    askedPath :: !Bytes.ByteString,
    askedHost :: !(Maybe Bytes.ByteString),
    askedOrigin :: !(Maybe Bytes.ByteString)
  }
  deriving (Eq, Show)

-- | The answer to a request.
data Answer
  = -- | A media type and the contents.
    Content !Bytes.ByteString !Lazy.ByteString
  | -- | The request comes from elsewhere, or does not know the token.
    Forbidden
  | -- | There is nothing of that name.
    Missing
  | -- | The method is neither GET nor HEAD.
    WrongMethod

-- | A message to the page.
data Outgoing
  = TextMessage !Lazy.ByteString
  | BinaryMessage !Lazy.ByteString

-- | The two ways of a WebSocket. Both actions may be called from any thread, but only
-- one thread at a time may call each.
data Connection = Connection
  { -- | The next message from the page; 'Nothing' when the page is gone.
    hear :: IO (Maybe Bytes.ByteString),
    -- | Send a message. Does nothing when the page is gone.
    send :: Outgoing -> IO ()
  }

-- | What the server serves.
data Service = Service
  { serviceAnswer :: Asked -> IO Answer,
    -- | The connection with a page that opens a WebSocket; 'Nothing' if it must not.
    serviceTalk :: Asked -> Maybe (Connection -> IO ())
  }

-- | The longest message that a page may send, in bytes: an animation of some hundred keys.
maximumMessageBytes :: Int
maximumMessageBytes = 1048576
