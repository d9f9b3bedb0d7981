-- | Random and hostile arguments and scene files: an answer after bounded work,
-- and never a crash.
module BlackHole.Cli.BadInputSpec (spec) where

import BlackHole.Cli.Help (Entry (..), parserEntries)
import BlackHole.Cli.Join (openTiles)
import BlackHole.Cli.Options
import BlackHole.Cli.Render.Options (renderScene)
import BlackHole.Cli.SceneOptions
import BlackHole.Image.Coding
import BlackHole.Image.File
import BlackHole.Image.Metadata (Metadata (..))
import BlackHole.Light.Display
import BlackHole.Light.Dither
import BlackHole.Light.Radiance (isFiniteRadiance)
import BlackHole.Render.Layer
import BlackHole.Render.PixelArray
import BlackHole.Render.PixelShape
import BlackHole.Render.Workers
import BlackHole.Scene.File.SceneFile (printScene)
import BlackHole.Scene.Preset (defaultScene)
import BlackHole.Trace.EnvironmentMap (environmentMapMean)
import qualified Codec.Picture as Juicy
import Control.Exception (evaluate)
import Control.Monad (forM_, join)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Characters
import qualified Data.ByteString.Lazy as Lazy
import Data.List (intercalate)
import qualified Data.Vector.Storable as Vector
import Support.Exposing
import Support.Panorama
import Support.Program (quietly)
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import System.Mem (getAllocationCounter)
import System.Timeout (timeout)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck

spec :: Spec
spec = do
  modifyMaxSuccess (const 2000) $ do
    it "answers any list of arguments" . property . forAll (listOf word) $
      answered . argumentsAnswer
    it "answers any arguments of a command" . property
      . forAll ((:) <$> elements commands <*> listOf word)
      $ answered . argumentsAnswer
  modifyMaxSuccess (const 500) $ do
    it "answers any bytes as a scene file" . property . forAll (listOf arbitrary) $
      answered . fileAnswer . Bytes.pack
    it "answers a scene file with bytes changed, lost and added" . property
      . forAll (mutated sceneBytes)
      $ answered . fileAnswer
  describe "answers with little work" $
    mapM_
      ( \(name, bytes) ->
          it
            name
            ( withLittleWork (wholly (fileAnswer bytes))
                >>= (`shouldSatisfy` maybe False (not . null))
            )
      )
      [ ("90000 unknown keys", lined ["k" ++ show n ++ ": 1" | n <- [1 .. 90000 :: Int]]),
        ("one key 90000 times", lined (replicate 90000 "seed: 1")),
        ("30000 small groups", lined ["g" ++ show n ++ ": {a: {b: 1}}" | n <- [1 .. 30000 :: Int]]),
        ( "300000 list items",
          Characters.pack ("camera: [" ++ intercalate "," (replicate 300000 "1") ++ "]")
        ),
        ("a list in lists, 100000 deep", Characters.replicate 100000 '['),
        ( "groups in groups, 500000 deep",
          Characters.concat (replicate 250000 (Characters.pack "{a: "))
        ),
        ( "aliases that double",
          lined
            ( "a0: &a0 [1,1]" :
                [ "a" ++ show n ++ ": &a" ++ show n ++ " [*a" ++ show (n - 1) ++ ",*a"
                    ++ show (n - 1)
                    ++ "]"
                  | n <- [1 .. 40 :: Int]
                ]
            )
        ),
        ("a megabyte of one word", Characters.replicate 1048576 'x'),
        ("a megabyte of one key", Characters.replicate 1048570 'x' <> Characters.pack ": 1"),
        ( "a number of a million digits",
          Characters.pack "camera: {distance: " <> Characters.replicate 1000000 '9'
            <> Characters.pack "}"
        ),
        ("a number with a vast exponent", Characters.pack "camera: {distance: 1e999999999}"),
        ("more bytes than a file may have", Characters.replicate 2000000 ' '),
        ("NUL bytes", Bytes.replicate 1000 0)
      ]
  it "answers an option's value of a million digits with little work" $
    withLittleWork (wholly (argumentsAnswer ["render", "--seed", replicate 1000000 '9']))
      >>= (`shouldSatisfy` maybe False (not . null))
  it "answers damaged pictures of every format, and damaged tiles" $
    withSystemTempDirectory "blackhole-spec" $ \folder ->
      forM_ ["a.png", "a.jpg", "a.tif", "a.hdr", "a.exr", "a.tile"] $ \name -> do
        quietly
          ( [ "render",
              "--width",
              "16",
              "--samples",
              "1",
              "--no-disk",
              "--integrator",
              "exact",
              "-o",
              folder </> name
            ]
              ++ ["--tile=1/1" | name == "a.tile"]
          )
          `shouldReturn` ExitSuccess
        bytes <- Bytes.readFile (folder </> name)
        forM_ [1 .. 100 :: Int] $ \_ -> do
          damaged <- generate (mutated bytes)
          Bytes.writeFile (folder </> "damaged.tile") damaged
          outcome <-
            withLittleWork $
              if name == "a.tile"
                then either length (const 0) <$> openTiles [folder </> "damaged.tile"]
                else evaluate (maybe 0 (length . metadataAnswer) (fileMetadata damaged))
          outcome `shouldSatisfy` maybe False (>= 0)
  it "takes at most 1024 scenes from the metadata of a picture with motion blur, in every format" $
    do
      let film = pixelShape 2 2 3 >>= (`fromPixelVector` Vector.replicate 12 0.5)
          written format text =
            join
              <$> traverse
                (encoded oneWorker format (Metadata "b" defaultCoding text) development noLayers)
                film
          development = Development (Exposure 0) ToneFilm noGrain NoDither
          lineCount = length (Characters.lines sceneBytes)
          forged n count =
            sceneBytes
              <> lined
                ( ("# moments " ++ show (n + 1)) :
                  replicate n ("# moment with lines " ++ show count)
                )
          scenesIn =
            either (const 0) length . resolveMetadata (SceneOptions Nothing Nothing []) "a.png"
          cases =
            [ (forged 1 lineCount, 2),
              (forged 1023 lineCount, 1024),
              (forged 1024 lineCount, 0),
              (forged 1023 (1000000 :: Int), 0)
            ]
      map (scenesIn . fst) cases `shouldBe` map snd cases
      forM_ ((,) <$> [minBound .. maxBound] <*> map fst cases) $ \(format, text) -> do
        file <- written format text
        (metadataScene <$> (fileMetadata . Lazy.toStrict =<< file)) `shouldBe` Just text
  forM_ panoramas $ \(name, whole) ->
    it ("answers damaged panoramas with little work and memory: " ++ name) $
      withSystemTempDirectory "blackhole-spec" $ \folder ->
        forM_ [1 .. 250 :: Int] $ \_ -> do
          damaged <- generate (oneof [mutated whole, scrambled whole])
          Bytes.writeFile (folder </> "damaged") damaged
          allowance <- getAllocationCounter
          outcome <-
            withLittleWork
              ( readPanorama (folder </> "damaged")
                  >>= evaluate
                    . either
                      length
                      (\image -> if isFiniteRadiance (environmentMapMean image) then 0 else -1)
              )
          left <- getAllocationCounter
          (damaged, outcome) `shouldSatisfy` maybe False (>= 0) . snd
          (damaged, allowance - left) `shouldSatisfy` (< 1000000000) . snd
  where
    panoramas =
      [ ("PNG", Lazy.toStrict (Juicy.encodePng picture)),
        ( "JPEG",
          Lazy.toStrict
            ( Juicy.encodeJpeg
                (Juicy.pixelMap (\(Juicy.PixelRGB8 r g b) -> Juicy.PixelYCbCr8 r g b) picture)
            )
        ),
        ("TIFF", Lazy.toStrict (Juicy.encodeTiff picture)),
        ( "HDR",
          Lazy.toStrict
            ( Juicy.encodeHDR
                ( Juicy.pixelMap
                    ( \(Juicy.PixelRGB8 r g b) ->
                        Juicy.PixelRGBF (fromIntegral r) (fromIntegral g) (fromIntegral b)
                    )
                    picture
                )
            )
        )
      ]
    picture =
      Juicy.generateImage
        ( \x y ->
            Juicy.PixelRGB8 (fromIntegral (5 * x)) (fromIntegral (9 * y)) (fromIntegral (x * y))
        )
        48
        24
    -- A few bytes of the first hundred, where the sizes are.
    scrambled bytes = do
      count <- choose (1, 4 :: Int)
      changes <- vectorOf count ((,) <$> choose (0, 100) <*> elements [0, 1, 0x7f, 0x80, 0xff])
      pure
        ( foldl
            ( \b (at, byte) ->
                let (start, end) = Bytes.splitAt at b in start <> Bytes.cons byte (Bytes.drop 1 end)
            )
            bytes
            changes
        )
    -- All of the answer is worked out by asking for its length.
    answered answer =
      ioProperty (maybe False (>= 0) <$> (withLittleWork . evaluate . length) answer)
    wholly answer = answer <$ evaluate (length answer)
    argumentsAnswer arguments = case parseArguments "v" arguments of
      Run (Render options) -> either unlines show (resolveScene (renderScene options) Nothing)
      other -> show other
    metadataAnswer found =
      either
        unlines
        show
        (resolveMetadata (SceneOptions Nothing Nothing []) "a.png" (metadataScene found))
    fileAnswer bytes =
      either unlines show (resolveScene (SceneOptions (Just "a.yaml") Nothing []) (Just bytes))
    lined = Characters.pack . unlines
    sceneBytes = Characters.pack (printScene [] defaultScene)
    commands = ["render", "join", "animate", "scene", "photon", "rays", "selftest", "help"]
    known =
      concatMap entryNames (parserEntries sceneOptions)
        ++ [ "-o",
             "--output",
             "--bits",
             "--from",
             "--tile",
             "--pixel",
             "--progress",
             "--help",
             "--",
             "-",
             "--impact",
             "--psi"
           ]
    word =
      frequency
        [ (6, elements known),
          (1, elements commands),
          (1, (\name value -> name ++ "=" ++ value) <$> elements known <*> anyValue),
          (5, anyValue),
          (1, arbitrary)
        ]
    anyValue =
      oneof
        [ elements
            [ "",
              "0",
              "-1",
              "NaN",
              "Infinity",
              "1e400",
              "-1e-400",
              "1,2,3",
              "1,2",
              "0,0,0",
              ",,,",
              "on",
              "OFF",
              "grid",
              "film",
              "1/3",
              "3/1",
              "0x10",
              "99999999999999999999",
              "\xfffd\&",
              "\0",
              "%s%n",
              "../..",
              "-"
            ],
          show <$> (arbitrary :: Gen Double),
          show <$> (arbitrary :: Gen Int),
          arbitrary
        ]
    mutated bytes = do
      count <- choose (1, 8 :: Int)
      go count bytes
    go 0 bytes = pure bytes
    go n bytes = do
      at <- choose (0, Bytes.length bytes)
      let (start, end) = Bytes.splitAt at bytes
      byte <-
        oneof
          [arbitrary, Bytes.head . Characters.pack . pure <$> elements "{}[]:,&*!|>'\"%@`#-\n\t "]
      lost <- choose (0, 40)
      changed <-
        elements
          [ start <> Bytes.cons byte end,
            start <> Bytes.cons byte (Bytes.drop 1 end),
            start <> Bytes.drop lost end,
            start
          ]
      go (n - 1) changed

-- | The result of an action, if it allocates at most 8 GB. That is the work of some
-- seconds, and unlike the time it does not depend on the machine. What works on for
-- ten minutes without allocating hangs.
withLittleWork :: IO a -> IO (Maybe a)
withLittleWork action = do
  allowance <- getAllocationCounter
  outcome <- timeout 600000000 action
  left <- getAllocationCounter
  pure (if allowance - left <= 8000000000 then outcome else Nothing)
