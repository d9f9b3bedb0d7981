-- | Every command line that the documents show works. Pictures are made small.
module DocumentsSpec (spec) where

import BlackHole.Cli.Help (topicNames)
import BlackHole.Cli.Options (Parsed (..), parseArguments)
import qualified Codec.Picture as Juicy
import Control.Applicative ((<|>))
import Control.Monad (filterM, forM_, unless, when)
import Data.Char (isAlpha, isSpace, isUpper)
import Data.List (dropWhileEnd, isInfixOf, isPrefixOf, isSuffixOf, nub, sort, stripPrefix)
import Data.Maybe (isJust, mapMaybe)
import GHC.IO.Encoding (setFileSystemEncoding, setLocaleEncoding, utf8)
import System.Directory (copyFile, createDirectoryIfMissing, doesFileExist, doesPathExist, findExecutable, listDirectory)
import System.Exit (ExitCode (..))
import System.FilePath (takeDirectory, takeExtension, (</>))
import System.IO.Temp (withSystemTempDirectory)
import System.Process (CreateProcess (cwd), proc, readCreateProcessWithExitCode)
import Test.Hspec

spec :: Spec
spec = before_ (setFileSystemEncoding utf8 >> setLocaleEncoding utf8) $ do
  describe "finding command lines" $ do
    it "takes code, and code within a sentence, not prose" $
      commandLines "Use blackhole render.\n\n    blackhole rays -o a.svg   # rays\n\nor `blackhole scene list` alone\n\n```\n$ script/blackhole selftest\n```\n"
        `shouldBe` [Command ["rays", "-o", "a.svg"] Nothing, Command ["scene", "list"] Nothing, Command ["selftest"] Nothing]
    it "knows shells" $ do
      commandLines "    blackhole render a.yaml --tile $i/4 -o big-$i.tile &\n" `shouldBe` [Command ["render", "a.yaml", "--tile", show i ++ "/4", "-o", "big-" ++ show i ++ ".tile"] Nothing | i <- [1 .. 4 :: Int]]
      commandLines "    until blackhole animate --status frames >/dev/null; do\n" `shouldBe` [Command ["animate", "--status", "frames"] Nothing]
      commandLines "    blackhole scene show default > mine.yaml   # all\n" `shouldBe` [Command ["scene", "show", "default"] (Just "mine.yaml")]
      commandLines "    blackhole render \\\n      -o a.png\n" `shouldBe` [Command ["render", "-o", "a.png"] Nothing]
    it "passes over what only stands for a value" $
      commandLines "    blackhole render --pixel X,Y\n    blackhole help TOPIC\n" `shouldBe` []
  documents <- runIO documentFiles
  it "there are many" $ do
    found <- concat <$> mapM (fmap commandLines . readFile) documents
    length found `shouldSatisfy` (>= 40)
  forM_ documents $ \document ->
    it ("work in " ++ document) $ readFile document >>= allWork . commandLines
  it "docs/options.md has every option of render in its tables, and no other" $ do
    text <- readFile "docs/options.md"
    let table = takeWhile (/= "## `blackhole animate`") (dropWhile (/= "## `blackhole render`") (lines text))
        options = filter ("--" `isPrefixOf`) . words . map (\c -> if c `elem` "`,()" then ' ' else c)
        listed = concatMap (options . takeWhile (/= '|') . drop 1) (filter (isPrefixOf "| `") table)
    sort listed `shouldBe` sort (nub listed)
    (listed, concatMap options' (lines (helpOf "render"))) `shouldSatisfy` \(a, b) -> sort (nub a) == sort (nub b)
  it "links of the documents lead to files" $ do
    targets <- concat <$> mapM (\document -> map (takeDirectory document </>) . links <$> readFile document) documents
    missing <- filterM (fmap not . doesPathExist) (nub targets)
    length targets `shouldSatisfy` (> 40)
    missing `shouldBe` []
  it "work in the program's help" $
    allWork (nub (concatMap (commandLines . unlines . mapMaybe shown . filter ("blackhole " `isInfixOf`) . filter (not . isPrefixOf "   ") . lines . helpOf) (topicNames ++ commands)))
  where
    commands = ["render", "animate", "join", "scene", "photon", "rays", "selftest"]
    -- The first column of the help is two spaces wide.
    options' line = case line of
      ' ' : ' ' : '-' : _ -> filter ("--" `isPrefixOf`) (words (filter (/= ',') (take 24 line)))
      _ -> []
    links text = case stripPrefix "](" text of
      Just rest | target <- takeWhile (`notElem` "#)") rest, not (null target), not ("http" `isPrefixOf` target) -> target : links rest
      _ -> maybe [] (links . drop 1) (if null text then Nothing else Just text)
    shown line = ("    " ++) <$> (stripPrefix "Example: " line <|> stripPrefix "  " line)
    helpOf word = case parseArguments "" ["help", word] of
      Inform text -> text
      _ -> ""

-- | Documents and scene files with words for people.
documentFiles :: IO [FilePath]
documentFiles = do
  docs <- listDirectory "docs"
  scenes <- listDirectory "scenes"
  pure (["README.md", "CONTRIBUTING.md"] ++ sort (["docs" </> f | f <- docs, takeExtension f == ".md"] ++ ["scenes" </> f | f <- scenes, takeExtension f `elem` [".md", ".yaml"]]))

-- | The program's arguments, and the file that its output goes to.
data Command = Command [String] (Maybe FilePath)
  deriving (Eq, Show)

-- | The command lines of a document, in its order.
commandLines :: String -> [Command]
commandLines = concatMap (mapMaybe command . repeated) . pieces False . joined . lines
  where
    joined (a : b : rest) | "\\" `isSuffixOf` a = joined ((dropWhileEnd isSpace (init' a) ++ " " ++ dropWhile isSpace b) : rest)
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
      (_, _ : rest) -> let (code, more) = break (== '`') rest in [code | "blackhole " `isPrefixOf` code, length (words code) > 2] ++ spans (drop 1 more)
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
    isPlaceholder word = any isUpper word && all (\c -> isUpper c || c `elem` ",/.[]…") word || "…" `isInfixOf` word
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

-- | Run command lines, one after the other, in a folder that has what they start
-- from. A film's state is also told by the code for missing frames.
allWork :: [Command] -> Expectation
allWork commands = unless (null commands) $ do
  found <- findExecutable "blackhole"
  ffmpeg <- isJust <$> findExecutable "ffmpeg"
  case found of
    Nothing -> pendingWith "blackhole is not on the PATH"
    Just program -> withSystemTempDirectory "blackhole-spec" $ \folder -> do
      prepare folder
      forM_ commands $ \(Command arguments output) -> do
        mapM_ (createDirectoryIfMissing True . (folder </>) . takeDirectory) (valuesOf ["-o", "--output"] arguments)
        forM_ (valuesOf ["--sky"] arguments) $ \sky ->
          when (takeExtension sky `elem` [".png", ".jpg", ".hdr", ".tif"]) $ panorama (folder </> sky)
        small <- concat <$> mapM (expanded folder) (scaled (if ffmpeg then arguments else without "--video" arguments))
        (code, said, complaint) <- readCreateProcessWithExitCode (proc program small) {cwd = Just folder} ""
        let allowed = ExitSuccess : [ExitFailure 5 | "--status" `elem` arguments]
        when (code `notElem` allowed) . expectationFailure $
          unwords ("blackhole" : small) ++ "\nended with " ++ show code ++ ":\n" ++ complaint
        forM_ output $ \file -> writeFile (folder </> file) said

valuesOf :: [String] -> [String] -> [String]
valuesOf names arguments = [value | (name, value) <- zip arguments (drop 1 arguments), name `elem` names]

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
    | otherwise -> arguments ++ size ++ ["--quiet"]
  "animate" : _
    | "--status" `elem` arguments -> arguments
    | otherwise -> arguments ++ size ++ ["--duration", "0.1"]
  _ -> arguments
  where
    size = ["--width", "16", "--height", "9", "--samples", "1"]

-- | The files that a pattern names.
expanded :: FilePath -> String -> IO [String]
expanded folder argument = case break (== '*') argument of
  (start, _ : end) -> sort . filter (\name -> start `isPrefixOf` name && end `isSuffixOf` name) <$> listDirectory folder
  _ -> pure [argument]

-- | The files that the documents' readers have.
prepare :: FilePath -> IO ()
prepare folder = do
  createDirectoryIfMissing True (folder </> "scenes")
  scenes <- listDirectory "scenes"
  forM_ scenes $ \name -> copyFile ("scenes" </> name) (folder </> "scenes" </> name)
  createDirectoryIfMissing True (folder </> "frames")
  forM_ [("mine.yaml", "image: {width: 16}\n"), ("big.yaml", "preset: report\n"), ("film.yaml", "animation: {frames: 2, camera-path: {kind: orbit}}\n")] $ \(name, text) ->
    writeFile (folder </> name) text
  found <- findExecutable "blackhole"
  forM_ found $ \program -> do
    forM_ ["big-1.tile"] $ \name ->
      readCreateProcessWithExitCode (proc program ["render", "--width", "16", "--samples", "1", "--tile", "1/1", "-o", name]) {cwd = Just folder} ""
    forM_ ["picture.exr", "hole.png"] $ \name ->
      readCreateProcessWithExitCode (proc program ["render", "--width", "16", "--samples", "1", "-o", name]) {cwd = Just folder} ""
    readCreateProcessWithExitCode (proc program ["animate", "film.yaml", "--width", "16", "--samples", "1", "-o", "frames/%05d.png"]) {cwd = Just folder} ""

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
      _ -> Juicy.writeHDR file (Juicy.generateImage (\x y -> Juicy.PixelRGBF (fromIntegral x) (fromIntegral y) 1) 32 16)
  where
    picture = Juicy.generateImage (\x y -> Juicy.PixelRGB8 (fromIntegral (8 * x)) (fromIntegral (8 * y)) 99) 32 16
