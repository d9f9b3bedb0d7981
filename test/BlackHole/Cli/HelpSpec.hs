module BlackHole.Cli.HelpSpec (spec) where

import qualified BlackHole.Animation.AnimationKeys as AnimationKeys
import BlackHole.Cli.Help
import BlackHole.Cli.Options
import BlackHole.Cli.Topics
import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Table (sceneFields)
import Data.Char (isUpper, toLower)
import Data.List (isInfixOf, isPrefixOf)
import Data.Maybe (fromMaybe)
import Test.Hspec

spec :: Spec
spec = do
  describe "help" $ do
    it "is there for every command and topic, with an example, in lines of at most 80 columns" $
      mapM_
        (\word -> (word, text ("help" : words word)) `shouldSatisfy` complete . snd)
        (commands ++ topicNames)
    it "of a command is what its --help says" $
      mapM_
        (\name -> text (words name ++ ["--help"]) `shouldBe` text ("help" : words name))
        commands
    it "and options of a command are described by whole phrases, without a full stop" $
      [ entryText e | c <- commandHelps, e <- commandEntries c, null (entryText e)
                                                                  || not
                                                                    ( isUpper
                                                                        (head' (entryText e))
                                                                        || take 1 (entryText e)
                                                                        == "%"
                                                                    )
                                                                  || '.'
                                                                  == last' (entryText e)
      ]
        `shouldBe` []
    it
      "knows a heading for every option that does not belong to a setting, and none that does not \
      \exist"
      $ mapM_
        ( \name ->
            concatMap commandEntries commandHelps `shouldSatisfy` any ((name `elem`) . entryNames)
        )
        (concatMap snd headedOptions)
    it "of scene lists the commands inside it" $
      mapM_
        (\name -> text ["help", "scene"] `shouldSatisfy` isInfixOf ("  " ++ name))
        (filter ("scene " `isPrefixOf`) commands)
    it "on films lists every key of the section animation" $
      mapM_
        (\name -> text ["help", "animation"] `shouldSatisfy` isInfixOf ("  " ++ name))
        ( map
            AnimationKeys.keyName
            ( AnimationKeys.animationKeys ++ AnimationKeys.cameraPathKeys
                ++ AnimationKeys.keyframeKeys
            )
            ++ ["camera-path", "keyframes"]
        )
    it "points to no file of the repository" $
      mapM_
        (\word -> text ("help" : words word) `shouldSatisfy` not . isInfixOf "docs/")
        (commands ++ topicNames)
    it "lists every topic and command" $
      mapM_
        (\word -> text ["--help"] `shouldSatisfy` isInfixOf word)
        (filter (notElem ' ') commands ++ topicNames)
    it "puts every option of a scene under its topic's heading" $
      mapM_
        ( \(f, o) ->
            under (topicName (fieldTopic f)) (text ["help", "render"])
              `shouldSatisfy` any (("  " ++ optionName o) `isPrefixOf`)
        )
        [(f, o) | f <- sceneFields, Just o <- [fieldOption f]]
    it "of a topic has every setting, also those of scene files alone" $
      mapM_
        ( \f ->
            text ["help", map toLower (topicName (fieldTopic f))]
              `shouldSatisfy` isInfixOf (fieldPath f)
        )
        sceneFields
    it "leaves no option of render without a heading" $
      lines (text ["help", "render"]) `shouldNotContain` ["This command:"]
    it "shows defaults" $
      text ["help", "camera"] `shouldSatisfy` isInfixOf "(default: -8)"
  describe "slips" $ do
    meant ["render", "--widht", "3"] "--width"
    meant ["animate", "--frame-rnage", "3"] "--frame-range"
    meant ["scene", "chek"] "check"
    meant ["help", "scene", "chek"] "scene check"
    meant ["photon", "--imapct", "3"] "--impact"
    it "of one letter have no suggestion" $
      show (parseArguments "v" ["render", "-w", "3"]) `shouldSatisfy` not . isInfixOf "did you mean"
    meant ["rnder"] "render"
    meant ["help", "camra"] "camera"
    meant ["render", "--observer", "statik"] "static"
  describe "mistakes are said in plain words" $ do
    says ["render", "--widht", "3"] "'--widht' is not an option (did you mean --width?)"
    says ["render", "-w", "3"] "'-w' is not an option"
    says ["render", "--width"] "option --width: its value is missing"
    says ["render", "a.yaml", "b.yaml"] "unexpected argument 'b.yaml'"
    says ["rendr"] "'rendr' is not a command (did you mean render?)"
    says ["help", "nothing"] "help: 'nothing' is not a command or a topic"
    says
      ["help", "spin"]
      "help: 'spin' is not a command or a topic; blackhole help observer explains --spin"
    says
      ["help", "shutter"]
      "help: 'shutter' is not a command or a topic; blackhole help animate explains --shutter"
  it "the manual page in docs is the one that the program prints" $ do
    page <- readFile "docs/blackhole.1"
    lines page `shouldBe` lines (text ["help", "man"])
  describe "completion" $ do
    completes ["render", "--tone"] "--tone-map"
    completes ["render", "--sky", "g"] "grid"
    completes ["help", "cam"] "camera"
    completes ["anim"] "animate"
    completes ["render", "--preset", "lum"] "luminet"
    completes ["scene", "show", "phot"] "photon-ring"
    completes ["render", "scenes/orb"] "scenes/orbit.yaml"
    completes ["scene", "check", "scenes/fa"] "scenes/fall.yaml"
    completes ["render", "sce"] "scenes/"
    completes ["help", "che"] "check"
    completes ["animate", "--codec", "av"] "av1"
    completes ["render", "--sky", "package.y"] "package.yaml"
    it "has scripts for three shells" $
      mapM_
        ( \shell ->
            fromMaybe
              (pure "")
              (completion "v" ["--" ++ shell ++ "-completion-script", "/bin/blackhole"])
              >>= (`shouldSatisfy` isInfixOf "/bin/blackhole")
        )
        ["bash", "zsh", "fish"]
  where
    commands = map commandName commandHelps
    head' = foldr const ' '
    last' = foldl (const id) ' '
    text arguments = case parseArguments "blackhole 0.1.0.0 (test)" arguments of
      Inform shown -> shown
      other -> show other
    complete shown =
      "Example" `isInfixOf` shown
        && all ((<= 80) . length) (filter (not . isInfixOf "blackhole ") (lines shown))
    under heading shown = takeWhile (/= "") (drop 1 (dropWhile (/= heading ++ ":") (lines shown)))
    meant arguments best =
      it ("of " ++ unwords arguments ++ " are told with " ++ best) $
        show (parseArguments "v" arguments)
          `shouldSatisfy` isInfixOf ("did you mean " ++ best ++ "?")
    says arguments line =
      it (unwords arguments) $ parseArguments "v" arguments `shouldBe` Misused line
    completes arguments word =
      it ("completes " ++ unwords arguments) $ do
        let asked =
              ["--bash-completion-index", show (length arguments)]
                ++ concat [["--bash-completion-word", w] | w <- "blackhole" : arguments]
        shown <- fromMaybe (pure "") (completion "v" asked)
        lines shown `shouldContain` [word]
