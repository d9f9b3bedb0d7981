-- | The documents agree with the program: their command lines work (with small
-- pictures), what they name exists, and the numbers they quote are those of the code.
module DocumentsSpec (spec) where

import BlackHole.Cli.ExitStatus (exitCode)
import BlackHole.Cli.Help
import BlackHole.Cli.Options (Parsed (..), commandHelps, formerOptions, parseArguments)
import BlackHole.Cli.Run (run)
import BlackHole.Cli.SceneOptions (sceneOptions)
import BlackHole.Cli.Topics
import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Kind (showValue)
import BlackHole.Scene.Field.Table (sceneFields)
import BlackHole.Scene.Preset (defaultScene, presetNames)
import qualified Codec.Picture as Juicy
import Control.Applicative ((<|>))
import Control.Monad (filterM, forM_, unless, when)
import Data.Char (isAlpha, isDigit, isSpace, isUpper)
import Data.List
  ( dropWhileEnd,
    isInfixOf,
    isPrefixOf,
    isSubsequenceOf,
    isSuffixOf,
    nub,
    sort,
    stripPrefix,
  )
import Data.Maybe (fromMaybe, isJust, mapMaybe)
import GHC.IO.Encoding (setFileSystemEncoding, setLocaleEncoding, utf8)
import Support.Program (outputOf, quietly, redirecting)
import System.Directory
  ( copyFile,
    createDirectoryIfMissing,
    doesFileExist,
    doesPathExist,
    findExecutable,
    listDirectory,
    withCurrentDirectory,
  )
import System.Exit (ExitCode (..))
import System.FilePath (takeDirectory, takeExtension, takeFileName, (</>))
import System.IO (stderr, stdout)
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec
import Text.Read (readMaybe)

spec :: Spec
spec = before_ (setFileSystemEncoding utf8 >> setLocaleEncoding utf8) $ do
  describe "finding command lines" $ do
    it "takes code, and code within a sentence, not prose" $
      commandLines
        "Use blackhole render.\n\n    blackhole rays -o a.svg   # rays\n\nor `blackhole \
        \scene list` alone\n\n```\n$ script/blackhole selftest\n```\n"
        `shouldBe` [ Command ["rays", "-o", "a.svg"] Nothing,
                     Command ["scene", "list"] Nothing,
                     Command ["selftest"] Nothing
                   ]
    it "knows shells" $ do
      commandLines "    blackhole render a.yaml --tile $i/4 -o big-$i.tile &\n"
        `shouldBe` [ Command
                       [ "render",
                         "a.yaml",
                         "--tile",
                         show i ++ "/4",
                         "-o",
                         "big-" ++ show i ++ ".tile"
                       ]
                       Nothing
                     | i <- [1 .. 4 :: Int]
                   ]
      commandLines "    until blackhole animate --status frames >/dev/null; do\n"
        `shouldBe` [Command ["animate", "--status", "frames"] Nothing]
      commandLines "    blackhole scene show default > mine.yaml   # all\n"
        `shouldBe` [Command ["scene", "show", "default"] (Just "mine.yaml")]
      commandLines "    blackhole render \\\n      -o a.png\n"
        `shouldBe` [Command ["render", "-o", "a.png"] Nothing]
    it "passes over what only stands for a value" $
      commandLines "    blackhole render --pixel X,Y\n    blackhole help TOPIC\n" `shouldBe` []
  documents <- runIO documentFiles
  it "there are many" $ do
    found <- concat <$> mapM (fmap commandLines . readFile) documents
    length found `shouldSatisfy` (>= 40)
  typed <- runIO (typedCommands <$> readFile transcript)
  it "the transcript has many commands" $ length typed `shouldSatisfy` (>= 20)
  aroundAll withReadersFiles $ do
    -- Some of its commands are mistakes.
    forM_ (filter (/= transcript) documents) $ \document ->
      it ("work in " ++ document) $ \files -> readFile document >>= allWork files . commandLines
    it "work in the program's help" $ \files ->
      allWork
        files
        ( nub
            ( concatMap
                ( commandLines . unlines . mapMaybe shown . filter ("blackhole " `isInfixOf`)
                    . filter (not . isPrefixOf "   ")
                    . lines
                    . helpOf
                )
                (topicNames ++ commands)
            )
        )
    describe ("the program still says what is in " ++ transcript) $
      forM_ typed $ \(arguments, expected) ->
        it (unwords arguments) $ \files ->
          withCurrentDirectory files $ do
            let makesPictures =
                  take 1 arguments == ["animate"] || any (" × " `isInfixOf`) expected
                small
                  | makesPictures = filter (/= "--quiet") (scaled arguments)
                  | otherwise = arguments
            ((_, complaint), printed) <-
              outputOf stdout "printed" (outputOf stderr "said" (run small))
            map withoutNumbers (filter (/= "…") expected)
              `shouldSatisfy` (`isSubsequenceOf` map withoutNumbers (lines (printed ++ complaint)))
  describe "docs/options.md" $ do
    text <- runIO (readFile "docs/options.md")
    let sectionOf name =
          takeWhile
            (not . isPrefixOf "## ")
            (drop 1 (dropWhile (/= "## `blackhole " ++ name ++ "`") (lines text)))
        rowsOf name = [map trim (splitCells row) | row <- sectionOf name, "| `" `isPrefixOf` row]
        -- A bar in a cell is written with a backslash.
        splitCells row = case break (== '|') (drop 1 row) of
          (cell, rest) | "\\" `isSuffixOf` cell -> case splitCells rest of
            next : others -> (cell ++ next) : others
            [] -> [cell]
          (_, "") -> []
          (cell, rest) -> cell : splitCells rest
        trim = dropWhileEnd isSpace . dropWhile isSpace
        optionsOf cell =
          filter ("--" `isPrefixOf`) (words (map (\c -> if c `elem` "`,()" then ' ' else c) cell))
        sceneNames = concatMap entryNames (parserEntries sceneOptions)
    forM_
      [ c | c <- commandHelps, commandName c
                                 `notElem` ["help", "scene"], ' ' `notElem` commandName c
      ]
      $ \c ->
        it ("lists every option of " ++ commandName c ++ " once, and no other") $ do
          let listed = concatMap (concatMap optionsOf . take 1) (rowsOf (commandName c))
              inherited = if commandName c `elem` ["animate", "explore"] then sceneNames else []
              own =
                [ name
                  | name <- concatMap entryNames (commandEntries c),
                    "--" `isPrefixOf` name,
                    name `notElem` inherited
                ]
          sort (nub listed) `shouldBe` sort own
          -- Both forms of --shard stand in one row.
          sort (filter (/= "--shard") listed) `shouldBe` sort (filter (/= "--shard") own)
    it "names every command of scene" $
      mapM_
        ( \c ->
            unlines (sectionOf "scene") `shouldSatisfy` isInfixOf ("blackhole " ++ commandName c)
        )
        [c | c <- commandHelps, "scene " `isPrefixOf` commandName c]
    it "has the defaults of the settings" $ do
      let tabled =
            concat
              [ zip (optionsOf names) (map trim (separated standard))
                | [names, _, standard] <- rowsOf "render",
                  standard /= ""
              ]
          separated cell = case break (== ',') cell of
            (a, _ : rest) -> a : separated rest
            (a, []) -> [a]
          plain = concatMap (\c -> if c == '\8722' then "-" else [c | c /= '`'])
          true =
            [ (optionName o, showValue value)
              | f <- sceneFields,
                not ("default" `isInfixOf` fieldDoc f),
                Just o@(Takes _ _) <- [fieldOption f],
                Just value <- [fieldGet f defaultScene]
            ]
      [(name, plain meaning) | (name, meaning) <- tabled, name `elem` map fst true]
        `shouldMatchList` true
  it "links of the documents lead to files" $ do
    targets <-
      concat
        <$> mapM
          (\document -> map (takeDirectory document </>) . links <$> readFile document)
          documents
    missing <- filterM (fmap not . doesPathExist) (nub targets)
    length targets `shouldSatisfy` (> 40)
    missing `shouldBe` []
  describe "the documents" $ do
    texts <-
      runIO
        ( mapM
            (\document -> (,) document <$> readFile document)
            (filter (\f -> takeExtension f == ".md") documents)
        )
    let spans = nub [(document, code) | (document, text) <- texts, code <- codeSpans text]
    it "name files that exist" $ do
      let named =
            [ (document, file)
              | (document, code) <- spans,
                file <- maybe [] pure (repositoryFile code)
            ]
      length named `shouldSatisfy` (> 30)
      filterM (fmap not . doesPathExist . snd) named `shouldReturn` []
    it "name modules that exist" $ do
      sources <- concat <$> mapM filesBelow ["src", "backend"]
      let places = map (++ "/") (sources ++ map takeDirectory sources)
          named = [(document, code) | (document, code) <- spans, isModuleName code]
          known code =
            any
              (\path -> any (path `isInfixOf`) places)
              [concatMap ('/' :) parts ++ end | parts <- [components code], end <- [".hs/", "/"]]
      length named `shouldSatisfy` (> 30)
      filter (not . known . snd) named `shouldBe` []
    it "name options that exist" $ do
      let options =
            concatMap (concatMap optionsIn . lines . helpOf) commands ++ ["--help", "--version"]
              ++ map fst formerOptions
              ++ scripts
          -- Of other programs: script/install and sbatch.
          scripts = ["--prefix", "--uninstall", "--array"]
          named =
            [ (document, option)
              | (document, code) <- spans,
                any (`isPrefixOf` code) ["-", "blackhole "],
                option <- optionsIn code
            ]
      length named `shouldSatisfy` (> 80)
      filter ((`notElem` options) . snd) named `shouldBe` []
    it "quote the numbers of the code" $
      forM_ quotations $ \(document, quotation, source, definition) -> do
        (document, lookup document texts)
          `shouldSatisfy` maybe False (isInfixOf (oneLine quotation) . oneLine) . snd
        code <- readFile source
        (source, code) `shouldSatisfy` isInfixOf (oneLine definition) . oneLine . snd
    it "cover every preset" $
      forM_ presetNames $ \name -> do
        lookup "docs/gallery.md" texts
          `shouldSatisfy` maybe False (isInfixOf ("\n## " ++ name ++ "\n"))
        lookup "scenes/README.md" texts
          `shouldSatisfy` maybe False (isInfixOf ("`" ++ name ++ ".yaml`"))
        doesFileExist ("scenes" </> name ++ ".yaml") `shouldReturn` True
    it "link to every document" $
      forM_ [f | (f, _) <- texts, takeDirectory f == "docs", f /= "docs/README.md"] $ \file -> do
        lookup "README.md" texts `shouldSatisfy` maybe False (elem file . links)
        lookup "docs/README.md" texts `shouldSatisfy` maybe False (elem (takeFileName file) . links)
    it "list every exit code" $ do
      let listed =
            [ listedCode
              | line <- maybe [] lines (lookup "README.md" texts),
                Just rest <- [stripPrefix "| " line],
                Just listedCode <- [readMaybe (takeWhile (/= ' ') rest)]
            ]
          code status = case exitCode status of
            ExitSuccess -> 0 :: Int
            ExitFailure n -> n
      listed `shouldBe` map code [minBound .. maxBound]
    it "name the modules that use CPP" $ do
      sources <-
        filter ((== ".hs") . takeExtension) . concat
          <$> mapM filesBelow ["app", "backend", "bench", "script", "src"]
      preprocessed <- filterM (fmap (isInfixOf "{-# LANGUAGE CPP") . readFile) sources
      preprocessed `shouldBe` ["src/BlackHole/Spacetime/Schwarzschild/Leapfrog.hs"]
      lookup "CONTRIBUTING.md" texts
        `shouldSatisfy` maybe
          False
          (isInfixOf "CPP, except in\n  `BlackHole.Spacetime.Schwarzschild.Leapfrog`")
  where
    commands = map commandName commandHelps
    optionsIn = filter isOption . words . map (\c -> if isAlpha c || c == '-' then c else ' ')
    isOption word = case word of
      '-' : '-' : c : _ -> isAlpha c
      _ -> False
    links text = case stripPrefix "](" text of
      Just rest
        | target <- takeWhile (`notElem` "#)") rest,
          not (null target),
          not ("http" `isPrefixOf` target) ->
          target : links rest
      _ -> maybe [] (links . drop 1) (if null text then Nothing else Just text)
    shown line = ("    " ++) <$> (stripPrefix "Example: " line <|> stripPrefix "  " line)
    helpOf word = case parseArguments "" ("help" : words word) of
      Inform text -> text
      _ -> ""

-- | A text with its line breaks and runs of spaces as single spaces.
oneLine :: String -> String
oneLine = unwords . words

-- | What a document says, and the text of the source that it must agree with, whatever
-- the line breaks: the document, the quotation, the source file and its text.
quotations :: [(FilePath, String, FilePath, String)]
quotations =
  [ ( "docs/architecture.md",
      "up to 24 octaves",
      "src/BlackHole/Spacetime/Schwarzschild/LensTable.hs",
      "octaveCount = 24"
    ),
    ( "docs/architecture.md",
      "octaves of 64 intervals",
      "src/BlackHole/Spacetime/Schwarzschild/LensTable.hs",
      "segmentCount = 64"
    ),
    ( "docs/performance.md",
      "Closer than 2⁻²⁴ to the critical path",
      "src/BlackHole/Spacetime/Schwarzschild/LensTable.hs",
      "closest = 0.5 ^^ octaveCount"
    ),
    ( "docs/physics.md",
      "b_c = 3√3/2 = 2.598076211353316",
      "src/BlackHole/Spacetime/Schwarzschild/Radii.hs",
      "criticalImpactParameter = 2.598076211353316"
    ),
    ( "docs/physics.md",
      "greatest at r = 4.7755",
      "src/BlackHole/SelfTest/Physics.hs",
      "(fst (thinDiskPeak (thinDisk noSpin))) 4.7755"
    ),
    ( "docs/physics.md",
      "Tracing stops when t < 0.01",
      "src/BlackHole/Trace/Gas.hs",
      "opaqueEnough = 0.01"
    ),
    ( "docs/physics.md",
      "and 10 beyond r = 40",
      "src/BlackHole/Spacetime/Schwarzschild/StepRule.hs",
      "| r2 > 1600 = 10"
    ),
    ( "docs/options.md",
      "1 to 65536",
      "src/BlackHole/Scene/Field/CameraTable.hs",
      "maximumPictureSide = 65536"
    ),
    ( "docs/sky.md",
      "8192 by 4096",
      "src/BlackHole/Image/Panorama.hs",
      "maximumPanoramaPixels = 8192 * 4096"
    ),
    ("docs/film.md", "64×64", "src/BlackHole/Light/Dither.hs", "ditherTileSide = 64")
  ]

-- | The code within the sentences and tables of a document.
codeSpans :: String -> [String]
codeSpans = concatMap (quoted . filter (/= '\\')) . prose False . lines
  where
    prose fenced (line : rest)
      | "```" `isPrefixOf` line = prose (not fenced) rest
      | fenced || "    " `isPrefixOf` line = prose fenced rest
      | otherwise = line : prose fenced rest
    prose _ [] = []
    quoted line = case break (== '`') line of
      (_, _ : rest) -> let (code, more) = break (== '`') rest in code : quoted (drop 1 more)
      _ -> []

-- | The file of the repository that a piece of code stands for, without what only
-- stands for a value. @Trace/PixelSpec@ is a file of the tests.
repositoryFile :: String -> Maybe FilePath
repositoryFile code = case words code of
  file : _
    | takeWhile (/= '/') file
        `elem` [".ci", "app", "backend", "bench", "docs", "scenes", "script", "src", "test"],
      '/' `elem` file && not ("NAME" `isInfixOf` file) ->
      Just file
    | "Spec" `isSuffixOf` file && '/' `elem` file -> Just ("test/BlackHole" </> file ++ ".hs")
  _ -> Nothing

-- | Whether it reads as a module of the library, as in @Physics.LensTable@; the name
-- of something that it exports may follow.
isModuleName :: String -> Bool
isModuleName code = length (components code) > 1 && all (\c -> isAlpha c || c == '.') code

-- | The parts of a module's name.
components :: String -> [String]
components = takeWhile (any isUpper . take 1) . words . map (\c -> if c == '.' then ' ' else c)

-- | All files in a folder and those inside it.
filesBelow :: FilePath -> IO [FilePath]
filesBelow folder = do
  entries <- map (folder </>) . sort <$> listDirectory folder
  concat
    <$> mapM
      ( \entry ->
          doesFileExist entry >>= \isFile -> if isFile then pure [entry] else filesBelow entry
      )
      entries

-- | Documents and scene files with words for people.
documentFiles :: IO [FilePath]
documentFiles = do
  docs <- listDirectory "docs"
  scenes <- listDirectory "scenes"
  pure
    ( ["README.md", "CONTRIBUTING.md", "CHANGELOG.md"]
        ++ sort
          ( ["docs" </> f | f <- docs, takeExtension f == ".md"]
              ++ ["scenes" </> f | f <- scenes, takeExtension f `elem` [".md", ".yaml"]]
          )
    )

-- | The first quarter of an hour, as it went.
transcript :: FilePath
transcript = "docs/first-quarter-hour.md"

-- | The program's arguments behind each @$ blackhole@ in the code of a transcript, and the
-- lines that follow it. A line of dots stands for some that were cut.
typedCommands :: String -> [([String], [String])]
typedCommands text = case dropWhile (not . isPrefixOf prompt) (lines text) of
  line : rest ->
    let (shown, more) = break (\l -> any (`isPrefixOf` l) ["$ ", "```"]) rest
     in (drop 2 (words line), filter (/= "") shown) : typedCommands (unlines more)
  [] -> []
  where
    prompt = "$ blackhole "

-- | A line without its numbers, which depend on the machine and on the picture's size, and
-- with single spaces.
withoutNumbers :: String -> String
withoutNumbers = unwords . words . shortened
  where
    shortened line = case break isDigit line of
      (start, _ : rest) -> start ++ '0' : shortened (dropWhile (\c -> isDigit c || c == '.') rest)
      (start, []) -> start

-- | The program's arguments, and the file that its output goes to.
data Command = Command [String] (Maybe FilePath)
  deriving (Eq, Show)

-- | The command lines of a document, in its order.
commandLines :: String -> [Command]
commandLines = concatMap (mapMaybe command . repeated) . pieces False . joined . lines
  where
    joined (a : b : rest)
      | "\\" `isSuffixOf` a =
        joined ((dropWhileEnd isSpace (init' a) ++ " " ++ dropWhile isSpace b) : rest)
    joined (a : rest) = a : joined rest
    joined [] = []
    init' = reverse . drop 1 . reverse
    pieces fenced (line : rest)
      | "```" `isPrefixOf` line = pieces (not fenced) rest
      | fenced = line : pieces fenced rest
      | Just code <- indented line = code : pieces fenced rest
      | otherwise = spans line ++ pieces fenced rest
    pieces _ [] = []
    indented line
      | "    " `isPrefixOf` line = Just (dropWhile isSpace line)
      | otherwise = stripPrefix "#   " line
    -- A span of code is a command line if it has more than a command's name.
    spans line = case break (== '`') line of
      (_, _ : rest) ->
        let (code, more) =
              break (== '`') rest
         in [code | "blackhole " `isPrefixOf` code, length (words code) > 2] ++ spans (drop 1 more)
      _ -> []
    repeated line
      | "$i" `isInfixOf` line = [replacing "$i" (show i) line | i <- [1 .. 4 :: Int]]
      | otherwise = [replacing "{}" "1" line]
    command line = case dropWhile (not . isProgram) (words (aside line)) of
      _ : arguments@(first : _)
        | all isAlpha first && not (any isPlaceholder arguments) ->
          let (own, more) = break isOperator arguments
           in Just (Command (map (dropWhileEnd (== ';')) own) (target more))
      _ -> Nothing
    isProgram word = word `elem` ["blackhole", "script/blackhole"]
    isOperator word = word `elem` [">", "|", "||", "&", "&&", ":::"] || ">" `isPrefixOf` word
    target (">" : file : _) = Just file
    target _ = Nothing
    isPlaceholder word =
      any isUpper word && all (\c -> isUpper c || c `elem` ",/.[]…") word
        || "…" `isInfixOf` word
    -- What follows after two spaces, or after a mark, is said to people.
    aside line = case line of
      ' ' : ' ' : _ -> ""
      ' ' : '#' : _ -> ""
      c : rest -> c : aside rest
      [] -> []

replacing :: String -> String -> String -> String
replacing old new text
  | Just rest <- stripPrefix old text = new ++ replacing old new rest
  | c : rest <- text = c : replacing old new rest
  | otherwise = []

-- | Runs command lines, one after the other, in a copy of the folder that has what they
-- start from. The exit code for missing frames also counts as success. All run in this
-- process, which decodes the stars once.
allWork :: FilePath -> [Command] -> Expectation
allWork files commands = unless (null commands)
  . withSystemTempDirectory "blackhole-spec"
  $ \folder -> do
    ffmpeg <- isJust <$> findExecutable "ffmpeg"
    copyFolder files folder
    withCurrentDirectory folder . forM_ commands $ \(Command arguments output) -> do
      mapM_ (createDirectoryIfMissing True . takeDirectory) (valuesOf ["-o", "--output"] arguments)
      forM_ (valuesOf ["--sky"] arguments) $ \sky ->
        when (takeExtension sky `elem` [".png", ".jpg", ".hdr", ".tif"]) $ panorama sky
      small <-
        concat
          <$> mapM expanded (scaled (if ffmpeg then arguments else without "--video" arguments))
      (code, complaint) <-
        outputOf stderr "said" (redirecting stdout (fromMaybe "printed" output) (run small))
      let allowed = ExitSuccess : [ExitFailure 5 | "--status" `elem` arguments]
      when (code `notElem` allowed) . expectationFailure $
        unwords ("blackhole" : small) ++ "\nended with " ++ show code ++ ":\n" ++ complaint

valuesOf :: [String] -> [String] -> [String]
valuesOf names arguments =
  [value | (name, value) <- zip arguments (drop 1 arguments), name `elem` names]

without :: String -> [String] -> [String]
without name arguments = case break (== name) arguments of
  (before', _ : _ : rest) -> before' ++ rest
  _ -> arguments

-- | The same with a small picture. The last of equal options counts; a single
-- pixel, and a file's tiles, need no help.
scaled :: [String] -> [String]
scaled arguments = case arguments of
  "render" : _
    | "--pixel" `elem` arguments -> arguments
    | otherwise -> arguments ++ filter (const (not adaptive)) ["--samples=1"] ++ size ++ ["--quiet"]
  "animate" : _
    | "--status" `elem` arguments -> arguments
    | otherwise -> arguments ++ ["--samples", "1", "--duration", "0.1"] ++ size
  -- It would serve for ever; this checks its options.
  "explore" : _ -> arguments ++ ["--help"]
  _ -> arguments
  where
    size = ["--width", "16", "--height", "8"]
    -- With one sample, the options of adaptive sampling would have no effect.
    adaptive = any (`elem` arguments) ["--noise", "--most-samples"]

-- | The files that a pattern names.
expanded :: String -> IO [String]
expanded argument = case break (== '*') argument of
  (start, _ : end) ->
    sort . filter (\name -> start `isPrefixOf` name && end `isSuffixOf` name) <$> listDirectory "."
  _ -> pure [argument]

-- | A folder with the files that the documents' readers have.
withReadersFiles :: (FilePath -> IO ()) -> IO ()
withReadersFiles action = withSystemTempDirectory "blackhole-spec" $ \folder -> do
  prepare folder
  action folder

copyFolder :: FilePath -> FilePath -> IO ()
copyFolder from to = do
  createDirectoryIfMissing True to
  names <- listDirectory from
  forM_ names $ \name -> do
    isFile <- doesFileExist (from </> name)
    (if isFile then copyFile else copyFolder) (from </> name) (to </> name)

prepare :: FilePath -> IO ()
prepare folder = do
  createDirectoryIfMissing True (folder </> "scenes")
  scenes <- listDirectory "scenes"
  forM_ scenes $ \name -> copyFile ("scenes" </> name) (folder </> "scenes" </> name)
  createDirectoryIfMissing True (folder </> "frames")
  forM_
    [ ("mine.yaml", "image: {width: 16}\n"),
      ("wrong.yaml", "preset: report\nimage: {width: 640}\n\n\ndisk:\n  arms: {cuont: 3}\n"),
      ("big.yaml", "preset: report\n"),
      ("film.yaml", "animation: {frames: 2, camera-path: {kind: orbit}}\n")
    ]
    $ \(name, text) ->
      writeFile (folder </> name) text
  withCurrentDirectory folder $
    mapM_
      (\arguments -> quietly arguments `shouldReturn` ExitSuccess)
      [ ["render", "--width", "16", "--samples", "1", "--tile", "1/1", "-o", "big-1.tile"],
        ["render", "--width", "16", "--samples", "1", "-o", "picture.exr"],
        ["render", "--width", "16", "--samples", "1", "-o", "hole.png"],
        ["animate", "film.yaml", "--width", "16", "--samples", "1", "-o", "frames/%05d.png"]
      ]

-- | A sky twice as wide as high.
panorama :: FilePath -> IO ()
panorama file = do
  there <- doesFileExist file
  unless there $ do
    createDirectoryIfMissing True (takeDirectory file)
    case takeExtension file of
      ".png" -> Juicy.writePng file picture
      ".jpg" -> Juicy.saveJpgImage 90 file (Juicy.ImageRGB8 picture)
      ".tif" -> Juicy.writeTiff file picture
      _ ->
        Juicy.writeHDR
          file
          (Juicy.generateImage (\x y -> Juicy.PixelRGBF (fromIntegral x) (fromIntegral y) 1) 32 16)
  where
    picture =
      Juicy.generateImage
        (\x y -> Juicy.PixelRGB8 (fromIntegral (8 * x)) (fromIntegral (8 * y)) 99)
        32
        16
