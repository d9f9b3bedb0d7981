{-# LANGUAGE OverloadedStrings #-}

-- | The web server of @blackhole explore@.
--
-- This is the back end on warp, wai and websockets. The one without a web library
-- exports the same names.
module BlackHole.Explore.Server
  ( serve,
  )
where

import BlackHole.Explore.Service
import Control.Exception (IOException, bracket, bracketOnError, catch, try)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Char8
import Network.HTTP.Types
import qualified Network.Socket as Socket
import Network.Wai
import Network.Wai.Handler.Warp
import Network.Wai.Handler.WebSockets (websocketsApp)
import Network.WebSockets hiding (Response, requestHeaders, send)
import qualified Network.WebSockets as WebSockets
import System.IO.Error (ioeGetErrorString)

-- | @serve port service started@ serves on the loopback interface alone, at the given
-- port or at a free one, until an exception ends it. The service and @started@ receive
-- the port; @started@ runs once requests can come. 'Left' says why it cannot listen.
serve :: Maybe (Maybe Int -> (Int -> Service) -> (Int -> IO ()) -> IO (Either String ()))
serve = Just $ \wanted serviceAt started -> do
  opened <- try (listening wanted)
  case opened of
    Left problem -> pure (Left (ioeGetErrorString (problem :: IOException)))
    Right socket -> bracket (pure socket) Socket.close $ \bound -> do
      port <- fromIntegral <$> Socket.socketPort bound
      let settings =
            setBeforeMainLoop (started port)
              . setServerName "blackhole"
              . setOnException (\_ _ -> pure ())
              . setHost "127.0.0.1"
              . setPort port
              $ defaultSettings
      Right <$> runSettingsSocket settings bound (application port (serviceAt port))

listening :: Maybe Int -> IO Socket.Socket
listening wanted = bracketOnError
  (Socket.socket Socket.AF_INET Socket.Stream Socket.defaultProtocol)
  Socket.close
  $ \socket -> do
    Socket.setSocketOption socket Socket.ReuseAddr 1
    Socket.withFdSocket socket Socket.setCloseOnExecIfNeeded
    Socket.bind
      socket
      (Socket.SockAddrInet (maybe 0 fromIntegral wanted) (Socket.tupleToHostAddress (127, 0, 0, 1)))
    Socket.listen socket 64
    pure socket

application :: Int -> Service -> Application
application port service request respond = case websocketsApp options talk request of
  Just upgraded -> respond upgraded
  Nothing -> serviceAnswer service asked >>= respond . answered port
  where
    asked =
      Asked
        { askedMethod = requestMethod request,
          askedPath = rawPathInfo request,
          askedHost = requestHeaderHost request,
          askedOrigin = lookup hOrigin (requestHeaders request)
        }
    options =
      defaultConnectionOptions
        { connectionFramePayloadSizeLimit = SizeLimit (fromIntegral maximumMessageBytes),
          connectionMessageDataSizeLimit = SizeLimit (fromIntegral maximumMessageBytes)
        }
    talk pending = case serviceTalk service asked of
      Nothing ->
        rejectRequestWith
          pending
          defaultRejectRequest
            { rejectCode = 403,
              rejectMessage = "Forbidden",
              rejectBody = "Forbidden\n"
            }
      Just serveSession -> do
        socket <- acceptRequest pending
        -- Warp ends connections that are silent for 30 seconds.
        withPingThread socket 10 (pure ()) . serveSession $
          Connection
            { hear =
                (Just . fromDataMessage <$> receiveDataMessage socket) `catch` gone Nothing
                  `catch` broken Nothing,
              send = \message ->
                WebSockets.sendDataMessage socket (dataMessage message) `catch` gone ()
                  `catch` broken ()
            }
    -- The page is gone, or does not follow the protocol.
    gone :: a -> ConnectionException -> IO a
    gone end _ = pure end
    broken :: a -> IOException -> IO a
    broken end _ = pure end
    dataMessage message = case message of
      TextMessage text -> Text text Nothing
      BinaryMessage bytes -> Binary bytes

hOrigin :: HeaderName
hOrigin = "Origin"

answered :: Int -> Answer -> Response
answered port answer = case answer of
  Content kind bytes -> responseLBS status200 (("Content-Type", kind) : guards port) bytes
  Forbidden -> plain status403 "Forbidden\n"
  Missing -> plain status404 "Not found\n"
  WrongMethod -> plain status405 "Method not allowed\n"
  where
    plain status = responseLBS status (("Content-Type", "text/plain") : guards port)

-- | Headers that keep the page to itself: it may load nothing from elsewhere, no other
-- page may frame it or read from it, and links do not tell its address.
guards :: Int -> [(HeaderName, Bytes.ByteString)]
guards port =
  [ ( "Content-Security-Policy",
      "default-src 'none'; script-src 'self'; style-src 'self'; img-src \
      \'self' blob: data:; connect-src 'self' "
        <> socketOn "127.0.0.1"
        <> " "
        <> socketOn "localhost"
        <> "; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
    ),
    ("X-Content-Type-Options", "nosniff"),
    ("Referrer-Policy", "no-referrer"),
    ("Cross-Origin-Resource-Policy", "same-origin"),
    ("Cross-Origin-Opener-Policy", "same-origin"),
    ("Cache-Control", "no-store")
  ]
  where
    -- Not every browser counts a WebSocket as 'self'.
    socketOn name = "ws://" <> name <> ":" <> Char8.pack (show port)
