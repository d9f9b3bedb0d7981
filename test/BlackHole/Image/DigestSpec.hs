module BlackHole.Image.DigestSpec (spec) where

import BlackHole.Image.Digest
import qualified Data.ByteString.Lazy as Lazy
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec

spec :: Spec
spec = do
  it "is SHA-256: the examples of FIPS 180-2, appendix B" $ do
    digestHex (digestText "abc")
      `shouldBe` "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"
    digestHex (digestBytes (Lazy.replicate 1000000 97))
      `shouldBe` "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0"
  it "is the same of a file" . withSystemTempDirectory "blackhole-spec" $ \folder -> do
    let bytes = Lazy.pack (take 200000 (cycle [0 .. 250]))
    Lazy.writeFile (folder </> "file") bytes
    digestFile (folder </> "file") `shouldReturn` (digestBytes bytes, 200000)
  it "can be read again, and nothing else can" $ do
    parseDigest (digestHex (digestText "ä")) `shouldBe` Just (digestText "ä")
    map parseDigest ["", replicate 63 'a', replicate 64 'A', replicate 64 'g']
      `shouldBe` replicate 4 Nothing
