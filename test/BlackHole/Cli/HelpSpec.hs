module BlackHole.Cli.HelpSpec (spec) where

import BlackHole.Cli.Help (topicNames)
import BlackHole.Cli.Options
import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Table (sceneFields)
import Data.Char (toLower)
import Data.List (isInfixOf, isPrefixOf)
import Data.Maybe (fromMaybe)
import Test.Hspec

spec :: Spec
spec = do
  describe "help" $ do
    it "is there for every command and topic, with an example, in lines of at most 84 columns" $
      mapM_ (\word -> text ["help", word] `shouldSatisfy` complete) (commands ++ topicNames)
    it "of a command is what its --help says" $
      mapM_ (\name -> text [name, "--help"] `shouldBe` text ["help", name]) (filter (/= "scene") commands)
    it "lists every topic and command" $
      mapM_ (\word -> text ["--help"] `shouldSatisfy` isInfixOf word) (commands ++ topicNames)
    it "puts every option of a scene under its topic's heading" $
      mapM_
        (\(f, o) -> under (topicName (fieldTopic f)) (text ["help", "render"]) `shouldSatisfy` any (("  " ++ optionName o) `isPrefixOf`))
        [(f, o) | f <- sceneFields, Just o <- [fieldOption f]]
    it "of a topic has every setting, also those of scene files alone" $
      mapM_ (\f -> text ["help", map toLower (topicName (fieldTopic f))] `shouldSatisfy` isInfixOf (fieldPath f)) sceneFields
    it "leaves no option of render without a heading" $
      lines (text ["help", "render"]) `shouldNotContain` ["This command:"]
    it "shows defaults" $
      text ["help", "camera"] `shouldSatisfy` isInfixOf "(default: -12)"
  describe "slips" $ do
    meant ["render", "--widht", "3"] "--width"
    meant ["animate", "--framse", "3"] "--frames"
    meant ["rnder"] "render"
    meant ["help", "camra"] "camera"
    meant ["render", "--observer", "statik"] "static"
  it "the manual page in docs is the one that the program prints" $ do
    page <- readFile "docs/blackhole.1"
    lines page `shouldBe` lines (text ["help", "man"])
  describe "completion" $ do
    completes ["render", "--tone"] "--tone-map"
    completes ["render", "--sky", "g"] "grid"
    completes ["help", "cam"] "camera"
    completes ["anim"] "animate"
    it "has scripts for three shells" $
      mapM_
        (\shell -> fromMaybe (pure "") (completion "v" ["--" ++ shell ++ "-completion-script", "/bin/blackhole"]) >>= (`shouldSatisfy` isInfixOf "/bin/blackhole"))
        ["bash", "zsh", "fish"]
  where
    commands = ["render", "join", "animate", "scene", "photon", "rays", "selftest"]
    text arguments = case parseArguments "blackhole 0.1.0.0 (test)" arguments of
      Inform shown -> shown
      other -> show other
    complete shown = "Example" `isInfixOf` shown && all ((<= 84) . length) (filter (not . isInfixOf "blackhole ") (lines shown))
    under heading shown = takeWhile (/= "") (drop 1 (dropWhile (/= heading ++ ":") (lines shown)))
    meant arguments best =
      it ("of " ++ unwords arguments ++ " are told with " ++ best) $
        show (parseArguments "v" arguments) `shouldSatisfy` isInfixOf ("did you mean " ++ best ++ "?")
    completes arguments word =
      it ("completes " ++ unwords arguments) $ do
        let asked = ["--bash-completion-index", show (length arguments)] ++ concat [["--bash-completion-word", w] | w <- "blackhole" : arguments]
        shown <- fromMaybe (pure "") (completion "v" asked)
        lines shown `shouldContain` [word]
