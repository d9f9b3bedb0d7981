module BlackHole.Cli.PreviewSpec (spec) where

import BlackHole.Cli.Preview
import BlackHole.Render.PixelArray
import BlackHole.Render.PixelShape
import qualified Data.Vector.Storable as Vector
import Data.Word (Word8)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "palette" $ do
    it "is letters where there is no terminal, or colour is not wanted" $
      [ palette False [("TERM", "xterm-256color"), ("COLORTERM", "truecolor")],
        palette True [("TERM", "xterm"), ("COLORTERM", "truecolor"), ("NO_COLOR", "1")],
        palette True [("TERM", "dumb")],
        palette True []
      ]
        `shouldBe` replicate 4 Letters
    it "is what the terminal promises" $
      [ palette True [("TERM", "xterm-256color"), ("COLORTERM", "truecolor"), ("NO_COLOR", "")],
        palette True [("TERM", "xterm"), ("COLORTERM", "24bit")],
        palette True [("TERM", "xterm-direct")],
        palette True [("TERM", "xterm-256color")]
      ]
        `shouldBe` [TrueColour, TrueColour, TrueColour, IndexedColour]
  describe "size" $ do
    it "fits a wide picture into the columns and a tall one into the lines" $ do
      previewSize 80 50 (1920, 1080) `shouldBe` (80, 44)
      previewSize 80 24 (1920, 1080) `shouldBe` (80, 44)
      previewSize 80 24 (100, 1000) `shouldBe` (5, 46)
    prop "never exceeds the terminal, and is never empty" $
      forAll
        ((,,,) <$> choose (1, 300) <*> choose (1, 100) <*> choose (1, 5000) <*> choose (1, 5000))
        $ \(columns, textLines, w, h) ->
          let (across, down) = previewSize columns textLines (w, h)
           in counterexample
                (show (across, down))
                ( across >= 1 && across <= columns && even down && down >= 2
                    && down <= 2 * max 1 (textLines - 1)
                )
  describe "text" $ do
    it "has two pixels in a character, in true colour" $
      previewText TrueColour (picture 1 2 [255, 0, 1, 2, 3, 4])
        `shouldBe` "\ESC[38;2;255;0;1m\ESC[48;2;2;3;4m▀\ESC[0m\n"
    it "says equal colours once" $
      previewText TrueColour (picture 2 2 (replicate 12 7))
        `shouldBe` "\ESC[38;2;7;7;7m\ESC[48;2;7;7;7m▀▀\ESC[0m\n"
    it "chooses xterm's nearest colours" $
      previewText IndexedColour (picture 2 2 [255, 0, 0, 95, 135, 175, 0, 0, 0, 118, 118, 118])
        `shouldBe` "\ESC[38;5;196m\ESC[48;5;16m▀\ESC[38;5;67m\ESC[48;5;243m▀\ESC[0m\n"
    it "grows denser with the light, in letters" $
      previewText
        Letters
        ( picture
            3
            2
            ([0, 0, 0, 128, 128, 128, 255, 255, 255] ++ [0, 0, 0, 128, 128, 128, 255, 255, 255])
        )
        `shouldBe` " =@\n"
    it "ends every line" $
      length (lines (previewText IndexedColour (picture 4 6 (replicate 72 9)))) `shouldBe` 3

picture :: Int -> Int -> [Word8] -> PixelArray Word8
picture width height codes =
  case pixelShape width height 3 >>= \shape -> fromPixelVector shape (Vector.fromList codes) of
    Just pixels -> pixels
    Nothing -> error "the test's picture has another size"
