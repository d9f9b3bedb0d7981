{-# LANGUAGE OverloadedStrings #-}

module BlackHole.Explore.AccessSpec (spec) where

import BlackHole.Explore.Access
import BlackHole.Explore.Service
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Char8
import Test.Hspec

spec :: Spec
spec = do
  it "answers a page that knows the token, at either name of this machine" $ do
    verdict own `shouldBe` Right "page.js"
    verdict own {askedHost = Just "localhost:4321", askedOrigin = Just "http://localhost:4321"}
      `shouldBe` Right "page.js"
    verdict own {askedMethod = "HEAD"} `shouldBe` Right "page.js"
    verdict own {askedPath = "/" <> token <> "/"} `shouldBe` Right ""
  it "refuses everybody else" $ do
    sequence_
      [ verdict asked `shouldBe` Left "forbidden"
        | asked <-
            [ own {askedPath = "/"},
              own {askedPath = "/page.js"},
              own {askedPath = "/" <> token},
              own {askedPath = "/" <> Bytes.take 31 token <> "/page.js"},
              own {askedPath = "/" <> Char8.map succ token <> "/page.js"},
              own {askedPath = "//" <> token <> "/page.js"},
              own {askedHost = Nothing},
              own {askedHost = Just "127.0.0.1"},
              own {askedHost = Just "127.0.0.1:80"},
              own {askedHost = Just "evil.example:4321"},
              own {askedHost = Just "127.0.0.1:4321.evil.example"},
              own {askedOrigin = Just "http://evil.example"},
              own {askedOrigin = Just "https://127.0.0.1:4321"},
              own {askedOrigin = Just "null"}
            ]
      ]
    verdict own {askedMethod = "POST"} `shouldBe` Left "method"
  it "lets only pages of its own talk" $ do
    let talk = own {askedPath = "/" <> token <> "/talk", askedOrigin = Just "http://127.0.0.1:4321"}
    admittedTalk access talk `shouldBe` True
    sequence_
      [ admittedTalk access asked `shouldBe` False
        | asked <-
            [ talk {askedOrigin = Nothing},
              talk {askedOrigin = Just "null"},
              talk {askedOrigin = Just "http://127.0.0.1:80"},
              talk {askedOrigin = Just "http://evil.example"},
              talk {askedHost = Just "evil.example:4321"},
              talk {askedPath = "/talk"},
              talk {askedPath = "/" <> Char8.map succ token <> "/talk"},
              talk {askedPath = "/" <> token <> "/talk/"}
            ]
      ]
  it "makes a new token of 128 bits each time" $ do
    tokens <- mapM (const newToken) [1 .. 20 :: Int]
    map Bytes.length tokens `shouldBe` replicate 20 32
    all (Char8.all (`elem` ("0123456789abcdef" :: String))) tokens `shouldBe` True
    [() | (i, a) <- zip [0 :: Int ..] tokens, (j, b) <- zip [0 ..] tokens, i < j, a == b]
      `shouldBe` []
  it "gives the address" $
    pageAddress access `shouldBe` "http://127.0.0.1:4321/0123456789abcdef0123456789abcdef/"

token :: Bytes.ByteString
token = "0123456789abcdef0123456789abcdef"

access :: Access
access = Access token 4321

own :: Asked
own = Asked "GET" ("/" <> token <> "/page.js") (Just "127.0.0.1:4321") Nothing

verdict :: Asked -> Either String Bytes.ByteString
verdict asked = case admitted access asked of
  Right path -> Right path
  Left Forbidden -> Left "forbidden"
  Left WrongMethod -> Left "method"
  Left _ -> Left "other"
