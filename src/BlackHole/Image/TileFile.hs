-- | Tile files: bands of a huge picture in separate files, until they are joined.
--
-- A tile file starts with several lines of text that identify the rows and the scene.
-- The linear light of the rows follows, as 32-bit floating-point numbers in
-- little-endian order. If pixels may have different numbers of samples, these numbers
-- follow in the same format. The file ends with the SHA-256 of everything before. Equal
-- scenes have equal texts, so files of different pictures can be told apart.
module BlackHole.Image.TileFile
  ( TileHeader (..),
    tileRows,
    encodeTile,
    TileFile,
    tileFilePath,
    tileFileHeader,
    openTile,
    tileIntact,
    readTileRows,
    readPictureRows,
    readCountsRow,
    joinFaults,
  )
where

import BlackHole.Render.Exposed (Film, SampleCounts)
import BlackHole.Render.PixelArray (fromPixelVector, pixelArrayShape, toPixelVector)
import BlackHole.Render.PixelShape (pixelShape, shapeHeight, shapeWidth)
import BlackHole.Render.Shard
import qualified Crypto.Hash.SHA256 as SHA256
import Data.Bits (shiftL, (.|.))
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import Data.ByteString.Unsafe (unsafeIndex)
import Data.List (intercalate, sort, sortOn)
import Data.Maybe (isJust, listToMaybe)
import qualified Data.Vector.Storable as Vector
import Data.Word (Word32)
import GHC.Float (castWord32ToFloat)
import System.IO (IOMode (ReadMode), SeekMode (AbsoluteSeek), hFileSize, hSeek, withBinaryFile)
import Text.Read (readMaybe)

-- | The description at the start of a tile.
data TileHeader = TileHeader
  { tileShard :: !Shard,
    -- | Width and height of the whole picture.
    tilePicture :: !(Int, Int),
    -- | Everything that the picture depends on, including the program's version, as
    -- lines of UTF-8 text.
    tileScene :: !Bytes.ByteString
  }
  deriving (Eq, Show)

-- | The first row of the tile and its number of rows.
tileRows :: TileHeader -> (Int, Int)
tileRows header = shardRows (tileShard header) (snd (tilePicture header))

-- | The bytes of a tile file, from the numbers of samples (if they differ between
-- pixels) and the light; 'Nothing' if the size of either does not match the header's
-- rows.
encodeTile :: TileHeader -> Maybe SampleCounts -> Film -> Maybe Lazy.ByteString
encodeTile header counts film
  | all ((== size) . sizeOf . pixelArrayShape) counts && sizeOf shape == size =
    Just (content <> Lazy.fromStrict (SHA256.hashlazy content))
  | otherwise = Nothing
  where
    shape = pixelArrayShape film
    sizeOf s = (shapeWidth s, shapeHeight s)
    size = (fst (tilePicture header), snd (tileRows header))
    content =
      Builder.toLazyByteString $
        Builder.byteString (renderHeader header (isJust counts)) <> floats film
          <> foldMap floats counts
    floats = Vector.foldr (\light rest -> Builder.floatLE light <> rest) mempty . toPixelVector

renderHeader :: TileHeader -> Bool -> Bytes.ByteString
renderHeader (TileHeader shard (width, height) scene) counted =
  Char8.pack
    ( unlines
        [ magic,
          "tile " ++ renderShard shard,
          "picture " ++ show width ++ " " ++ show height,
          "counts " ++ (if counted then "yes" else "no"),
          "scene " ++ show (Bytes.length scene)
        ]
    )
    <> scene

magic :: String
magic = "blackhole tile 2"

-- | A tile file whose header has been read, and the position of its light.
data TileFile = TileFile
  { -- | The path of the file.
    tileFilePath :: !FilePath,
    -- | The description at its start.
    tileFileHeader :: !TileHeader,
    tileFileStart :: !Integer,
    -- | Whether it contains the numbers of samples.
    tileFileCounted :: !Bool
  }

-- | Opens a file. 'Left' holds the reason if it is not a complete tile. Throws the
-- exceptions of the file system.
openTile :: FilePath -> IO (Either String TileFile)
openTile path = withBinaryFile path ReadMode $ \handle -> do
  start <- Bytes.hGet handle 256
  size <- hFileSize handle
  case splitHeader start of
    Nothing -> pure (Left "not a tile file")
    Just (shard, picture, counted, skipped, textLength) -> do
      hSeek handle AbsoluteSeek (toInteger skipped)
      text <- Bytes.hGet handle textLength
      let header = TileHeader shard picture text
          begin = toInteger (skipped + textLength)
          wanted =
            begin + (if counted then 16 else 12) * toInteger (fst picture)
              * toInteger
                (snd (tileRows header))
              + 32
      pure $
        if size == wanted
          then Right (TileFile path header begin counted)
          else Left ("incomplete: " ++ show size ++ " bytes instead of " ++ show wanted)
  where
    splitHeader bytes = case Char8.lines bytes of
      m : t : p : c : s : _
        | m == Char8.pack magic,
          ["tile", shard] <- words (Char8.unpack t),
          ["picture", width, height] <- words (Char8.unpack p),
          Just counted <- lookup (Char8.unpack c) [("counts yes", True), ("counts no", False)],
          ["scene", size] <- words (Char8.unpack s) -> do
          part <- parseShard shard
          w <- readMaybe width
          h <- readMaybe height
          n <- readMaybe size
          if w < 1 || h < 1 || w > 10000000 || h > 10000000 || n < 0 || n > 10000000
            then Nothing
            else Just (part, (w, h), counted, sum (map ((+ 1) . Bytes.length) [m, t, p, c, s]), n)
      _ -> Nothing

-- | Whether the file's contents match their SHA-256. Reads the whole file in constant
-- memory.
tileIntact :: TileFile -> IO Bool
tileIntact tile = withBinaryFile (tileFilePath tile) ReadMode $ \handle -> do
  size <- hFileSize handle
  let go context left
        | left <= 0 = do
          written <- Bytes.hGet handle 32
          pure (written == SHA256.finalize context)
        | otherwise = do
          chunk <- Bytes.hGetSome handle (fromInteger (min 262144 left))
          if Bytes.null chunk
            then pure False
            else do
              let next = SHA256.update context chunk
              next `seq` go next (left - toInteger (Bytes.length chunk))
  go SHA256.init (size - 32)

-- | A band of the tile: the first row, counted from the tile's own, and the number of
-- rows. 'Nothing' if the tile has no such rows.
readTileRows :: TileFile -> (Int, Int) -> IO (Maybe Film)
readTileRows tile (first, rows)
  | first < 0 || rows < 1 || first + rows > snd (tileRows header) = pure Nothing
  | otherwise = do
    light <- readFloats tile (12 * toInteger width * toInteger first) (3 * width * rows)
    pure $ do
      shape <- pixelShape width rows 3
      light >>= fromPixelVector shape
  where
    header = tileFileHeader tile
    (width, _) = tilePicture header

-- | Reads this many numbers from a position after the header.
readFloats :: TileFile -> Integer -> Int -> IO (Maybe (Vector.Vector Float))
readFloats tile place count = withBinaryFile (tileFilePath tile) ReadMode $ \handle -> do
  hSeek handle AbsoluteSeek (tileFileStart tile + place)
  bytes <- Bytes.hGet handle (4 * count)
  pure
    ( if Bytes.length bytes < 4 * count
        then Nothing
        else Just (Vector.generate count (floatAt bytes))
    )
  where
    floatAt bytes i =
      castWord32ToFloat
        (at 0 .|. at 1 `shiftL` 8 .|. at 2 `shiftL` 16 .|. at 3 `shiftL` 24)
      where
        at k = fromIntegral (unsafeIndex bytes (4 * i + k)) :: Word32

-- | The numbers of samples of the pixels in a row of the picture, from the tile that
-- contains it. 'Nothing' if no tile contains the row or the tile does not record them.
readCountsRow :: [TileFile] -> Int -> IO (Maybe (Vector.Vector Float))
readCountsRow tiles row = case filter holds tiles of
  tile : _
    | tileFileCounted tile ->
      let (from, rows) = tileRows (tileFileHeader tile)
          width = fst (tilePicture (tileFileHeader tile))
       in readFloats
            tile
            (toInteger width * (12 * toInteger rows + 4 * toInteger (row - from)))
            width
  _ -> pure Nothing
  where
    holds tile =
      let (from, rows) = tileRows (tileFileHeader tile)
       in row >= from
            && row < from + rows

-- | A band of the whole picture (first row and number of rows), from the tiles that
-- contain it. The tiles must be free of 'joinFaults'. 'Nothing' if the picture has no
-- such rows, or a file has become shorter.
readPictureRows :: [TileFile] -> (Int, Int) -> IO (Maybe Film)
readPictureRows tiles (first, rows) = do
  parts <- sequence <$> mapM part (sortOn (fst . tileRows . tileFileHeader) overlapping)
  pure $ do
    films <- parts
    width <- listToMaybe [fst (tilePicture (tileFileHeader tile)) | tile <- tiles]
    shape <- pixelShape width rows 3
    fromPixelVector shape (Vector.concat (map toPixelVector films))
  where
    overlapping =
      filter
        ( \tile ->
            let (from, count) = span' tile
             in count > 0 && from + count > first
                  && from < first + rows
        )
        tiles
    span' = tileRows . tileFileHeader
    part tile =
      let (from, count) = span' tile
          start = max 0 (first - from)
       in readTileRows tile (start, min count (first + rows - from) - start)

-- | All reasons why tiles cannot be joined: there are none, a tile belongs to a
-- different picture than the first, or a part is duplicated or missing.
joinFaults :: [(FilePath, TileHeader)] -> [String]
joinFaults [] = ["there are no tiles to join"]
joinFaults tiles@((firstPath, first) : _)
  | not (null foreign') = foreign'
  | otherwise = twice ++ missing
  where
    foreign' =
      [ path ++ " belongs to another picture than " ++ firstPath ++ ": " ++ difference header
        | (path, header) <- tiles,
          different header
      ]
    different header =
      (count header, tilePicture header, tileScene header)
        /= (count first, tilePicture first, tileScene first)
    difference header
      | tilePicture header /= tilePicture first = size header ++ " pixels instead of " ++ size first
      | count header /= count first =
        "one of " ++ show (count header) ++ " tiles instead of "
          ++ show (count first)
      | otherwise =
        case [ (a, b)
               | (a, b) <- zip (Char8.lines (tileScene header)) (Char8.lines (tileScene first)),
                 a /= b
             ] of
          (a, b) : _ -> trimmed a ++ " instead of " ++ trimmed b
          [] -> "another scene"
    size header = show (fst (tilePicture header)) ++ " x " ++ show (snd (tilePicture header))
    trimmed = unwords . words . Char8.unpack
    count = shardCount . tileShard
    parts = sort [(shardIndex (tileShard header), path) | (path, header) <- tiles]
    twice =
      [ "tile " ++ renderShard (Shard i (count first)) ++ " is there twice: " ++ a ++ " and " ++ b
        | ((i, a), (j, b)) <- zip parts (drop 1 parts),
          i == j
      ]
    missing =
      case [renderShard (Shard i (count first)) | i <- absent [1 .. count first] (map fst parts)] of
        [] -> []
        [one] -> ["tile " ++ one ++ " is missing"]
        several ->
          [ "tiles " ++ intercalate ", " (take 20 several)
              ++ (if length several > 20 then ", ..." else "")
              ++ " are missing"
          ]
    absent (i : is) (p : ps)
      | p < i = absent (i : is) ps
      | p == i = absent is ps
      | otherwise = i : absent is (p : ps)
    absent is [] = is
    absent [] _ = []
