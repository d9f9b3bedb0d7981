module BlackHole.Image.TileFileSpec (spec) where

import BlackHole.Image.TileFile
import BlackHole.Render.PixelArray
import BlackHole.Render.PixelShape
import BlackHole.Render.Shard
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import Data.List (isInfixOf)
import qualified Data.Vector.Storable as Vector
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec

spec :: Spec
spec = do
  it "gives back the light it was given, row by row, infinities included" . inFolder $ \folder -> do
    writeTile (folder </> "2.tile") header
    opened <- openTile (folder </> "2.tile")
    case opened of
      Left reason -> expectationFailure reason
      Right tile -> do
        tileFileHeader tile `shouldBe` header
        tileIntact tile `shouldReturn` True
        whole <- readTileRows tile (0, 4)
        fmap toPixelVector whole `shouldBe` Just light
        part <- readTileRows tile (1, 2)
        fmap toPixelVector part `shouldBe` Just (Vector.slice 15 30 light)
        mapM (fmap (fmap toPixelVector) . readTileRows tile) [(3, 2), (-1, 1), (0, 0)]
          `shouldReturn` [Nothing, Nothing, Nothing]
  it "gives rows of the picture out of the tiles that hold them" . inFolder $ \folder -> do
    tiles <-
      mapM (\i -> writeTileAt i (folder </> show i) >> openTile (folder </> show i)) [3, 1, 2]
    case sequence tiles of
      Left reason -> expectationFailure reason
      Right found -> do
        let rowsOf i = Vector.map (+ fromIntegral i) plainLight
            picture = Vector.concat (map rowsOf [1 :: Int, 2, 3])
            rows range = fmap toPixelVector <$> readPictureRows found range
        rows (0, 12) `shouldReturn` Just picture
        mapM rows [(0, 1), (3, 2), (2, 9), (11, 1)]
          `shouldReturn` [ Just (Vector.slice (15 * from) (15 * count) picture)
                           | (from, count) <- [(0, 1), (3, 2), (2, 9), (11, 1)]
                         ]
        mapM rows [(-1, 2), (11, 2), (12, 1), (4, 0)]
          `shouldReturn` [Nothing, Nothing, Nothing, Nothing]
  it "gives the numbers of samples of a row, if the tile that holds it has them" . inFolder $
    \folder -> do
      tiles <-
        mapM (\i -> writeTileAt i (folder </> show i) >> openTile (folder </> show i)) [3, 1, 2]
      case sequence tiles of
        Left reason -> expectationFailure reason
        Right found ->
          mapM (readCountsRow found) [-1, 0, 3, 4, 8, 11, 12]
            `shouldReturn` [ Nothing,
                             Just (Vector.fromList [1 .. 5]),
                             Just (Vector.fromList [16 .. 20]),
                             Nothing,
                             Just (Vector.fromList [3 .. 7]),
                             Just (Vector.fromList [18 .. 22]),
                             Nothing
                           ]
  it "notices a changed byte wherever it is, a missing end, and what is no tile" . inFolder $
    \folder -> do
      let file = folder </> "2.tile"
      writeTile file header
      bytes <- Bytes.readFile file
      let changedAt n =
            Bytes.concat
              [ Bytes.take n bytes,
                Bytes.map (+ 1) (Bytes.take 1 (Bytes.drop n bytes)),
                Bytes.drop (n + 1) bytes
              ]
      intact <-
        mapM
          ( \n ->
              Bytes.writeFile file (changedAt n)
                >> openTile file >>= either (const (pure False)) tileIntact
          )
          [0, 7 .. Bytes.length bytes - 1]
      or intact `shouldBe` False
      Bytes.writeFile file (Bytes.take (Bytes.length bytes - 1) bytes)
      openTile file
        >>= either (`shouldSatisfy` isInfixOf "incomplete") (const (expectationFailure "taken"))
      mapM_
        ( \junk ->
            Bytes.writeFile file junk >> openTile file
              >>= either (`shouldBe` "not a tile file") (const (expectationFailure "taken"))
        )
        [Bytes.empty, Char8.pack "P6 1 1", Bytes.replicate 1000 10]
  it "does not take a film of another size" $
    fmap Lazy.length (pixelArrayOf 5 3 >>= encodeTile header Nothing) `shouldBe` Nothing
  describe "joinFaults" $ do
    let tile i = ("t" ++ show i, header {tileShard = Shard i 3})
    it "finds none in a complete set in any order" $ joinFaults (map tile [3, 1, 2]) `shouldBe` []
    it "names what is missing" $ do
      joinFaults (map tile [1, 3]) `shouldBe` ["tile 2/3 is missing"]
      joinFaults (map tile [3]) `shouldBe` ["tiles 1/3, 2/3 are missing"]
      joinFaults [] `shouldBe` ["there are no tiles to join"]
    it "names what is there twice" $
      joinFaults (map tile [1, 2, 3] ++ [("again", snd (tile 2))])
        `shouldBe` ["tile 2/3 is there twice: again and t2"]
    it "names what belongs to another picture, and the difference" $ do
      joinFaults [tile 1, ("x", (snd (tile 2)) {tileScene = Char8.pack "a: 1\nb:  3\n"})]
        `shouldBe` ["x belongs to another picture than t1: b: 3 instead of b: 2"]
      joinFaults [tile 1, ("x", (snd (tile 2)) {tilePicture = (5, 13)})]
        `shouldBe` ["x belongs to another picture than t1: 5 x 13 pixels instead of 5 x 12"]
      joinFaults [tile 1, ("x", (snd (tile 2)) {tileShard = Shard 2 4})]
        `shouldBe` ["x belongs to another picture than t1: one of 4 tiles instead of 3"]
  where
    inFolder = withSystemTempDirectory "blackhole-spec"
    header = TileHeader (Shard 2 3) (5, 12) (Char8.pack "a: 1\nb: 2\n")
    light =
      Vector.fromList
        (take 60 ([0, 1 / 0, -0.5, 1e-40] ++ map ((* 0.37) . fromIntegral) [1 :: Int ..]))
    pixelArrayOf :: Int -> Int -> Maybe (PixelArray Float)
    pixelArrayOf width height = do
      shape <- pixelShape width height 3
      fromPixelVector shape (Vector.take (3 * width * height) light)
    plainLight = Vector.fromList (map (* 0.37) (take 60 [1 ..]))
    writeTileAt i file =
      maybe (expectationFailure "no tile") (Lazy.writeFile file) $ do
        shape <- pixelShape 5 4 3
        film <- fromPixelVector shape (Vector.map (+ fromIntegral i) plainLight)
        encodeTile header {tileShard = Shard i 3} (if i == 2 then Nothing else countsOf i) film
    countsOf i =
      pixelShape 5 4 1 >>= \shape ->
        fromPixelVector shape (Vector.generate 20 (\k -> fromIntegral (i + k)))
    writeTile file h =
      maybe
        (expectationFailure "no tile")
        (Lazy.writeFile file)
        (pixelArrayOf 5 4 >>= encodeTile h Nothing)
