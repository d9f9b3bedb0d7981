module BlackHole.Image.JpegSegmentsSpec (spec) where

import BlackHole.Image.JpegSegments
import qualified Codec.Picture as Juicy
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import System.Directory (listDirectory)
import System.FilePath (takeExtension, (</>))
import Test.Hspec

spec :: Spec
spec = do
  it "passes what encoders write" $ do
    soundJpeg plain `shouldBe` True
    names <- filter ((== ".jpg") . takeExtension) <$> listDirectory "docs/gallery"
    sound <- mapM (fmap soundJpeg . Bytes.readFile . ("docs/gallery" </>)) names
    sound `shouldSatisfy` \all' -> length all' >= 9 && and all'
  it "passes a file whose last marker is lost" $
    soundJpeg (Bytes.take (Bytes.length plain - 2) plain) `shouldBe` True
  it "refuses more Huffman codes than there can be: the bytes that JuicyPixels never ends with" $
    soundJpeg (changed (5 + tables) 0x31) `shouldBe` False
  it "refuses codes that fill more than there is" $ do
    -- The first table has one code of two bits and five of three: 7/8 of all words.
    soundJpeg (changed (tables + 5) 1) `shouldBe` False
  it "refuses sampling factors of 0 and above 4, a second frame, and segments beyond the end" $ do
    soundJpeg (changed (frame + 11) 0) `shouldBe` False
    soundJpeg (changed (frame + 11) 0x51) `shouldBe` False
    soundJpeg (Bytes.take frame plain <> header <> Bytes.drop frame plain) `shouldBe` False
    soundJpeg (changed (frame + 2) 0xff) `shouldBe` False
    soundJpeg Bytes.empty `shouldBe` False
  it
    "refuses a scan of tables that are not there, with which JuicyPixels never ends either, and \
    \of components that are not"
    $ do
      soundJpeg (changed (scan + 6) 0x40) `shouldBe` False
      soundJpeg (changed (scan + 6) 0x03) `shouldBe` False
      soundJpeg (changed (scan + 5) 9) `shouldBe` False
      soundJpeg (changed (scan + 7) 1) `shouldBe` False
      soundJpeg (changed (tables + 1) 0xfd) `shouldBe` False
  where
    plain =
      Lazy.toStrict
        ( Juicy.encodeJpeg
            ( Juicy.generateImage
                (\x y -> Juicy.PixelYCbCr8 (fromIntegral (5 * x * y)) 99 (fromIntegral y))
                48
                24
            )
        )
    place marker = Bytes.length (fst (Bytes.breakSubstring (Bytes.pack [0xff, marker]) plain))
    tables = place 0xc4
    frame = place 0xc0
    scan = place 0xda
    header = Bytes.take 19 (Bytes.drop frame plain)
    changed at byte = Bytes.take at plain <> Bytes.cons byte (Bytes.drop (at + 1) plain)
