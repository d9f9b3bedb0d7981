module BlackHole.Cli.PhotonSpec (spec) where

import BlackHole.Cli.Photon
import BlackHole.Scene.Validate (Problem (..), renderProblem)
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.List (isInfixOf, isPrefixOf)
import Data.Maybe (mapMaybe)
import Options.Applicative
import Support.Approx
import Support.Json
import Test.Hspec
import Text.Read (readMaybe)

spec :: Spec
spec = do
  describe "--json" $ do
    it "prints the deflection of --impact 2.65 within 1e-10" $
      at ["deflection"] ["--impact", "2.65"] >>= (`shouldBeWithin` (1e-10, 3.55793804245965))
    it "has exactly these keys" $
      mapM_
        (\arguments -> fmap keys (json arguments) `shouldReturn` reportKeys)
        [["--impact", "2.65"], ["--impact", "2.5"], ["--impact", "0"], camera]
    it "is null where a captured path has no value" $ do
      captured <- json ["--impact", "2.5"]
      member "fate" captured `shouldBe` Just (Text "captured")
      member "deflection" captured `shouldBe` Just Null
      member "closestApproach" captured `shouldBe` Just Null
    it "gives each crossing its radius, azimuth and shift" $ do
      report <- json camera
      case member "crossings" report of
        Just (List [first, second]) -> do
          map keys [first, second] `shouldBe` replicate 2 ["r", "azimuth", "g"]
          mapM_
            (\(crossing, key, reference) -> maybe (expectationFailure key) (`shouldBeWithin` (1e-8, reference)) (numberAt [key] crossing))
            [(first, "r", 10.27369270291), (first, "g", 0.94812614213424), (second, "azimuth", -1.57079632679)]
        other -> expectationFailure (show other)
    it "sets the leapfrog's values beside the exact ones and the errors" $ do
      report <- json (camera ++ ["--integrator", "leapfrog", "--step", "0.05"])
      keys report `shouldBe` reportKeys ++ ["exact", "error"]
      fmap keys (member "exact" report) `shouldBe` Just reportKeys
      case (numberAt ["sweptAngle"] report, numberAt ["exact", "sweptAngle"] report, numberAt ["error", "sweptAngle"] report) of
        (Just stepped, Just exact, Just difference) -> do
          difference `shouldBeWithin` (1e-14, stepped - exact)
          abs difference `shouldSatisfy` (\e -> e > 1e-8 && e < 1e-3)
        other -> expectationFailure (show other)
    it "--step is what makes the error smaller" $ do
      -- Down to the error of the report's steps beyond r = 40, which are fixed.
      errors <- mapM (\l -> abs <$> at ["error", "deflection"] (camera ++ ["--integrator", "leapfrog", "--step", l])) ["0.16", "0.08", "0.04"]
      zipWith (/) errors (drop 1 errors) `shouldSatisfy` all (\q -> abs (q - 4) < 0.6)
  describe "the table" $ do
    it "has a row for each value" $ do
      rows <- lines <$> text camera
      map (takeWhile (/= ' ')) rows
        `shouldBe` ["fate", "impactParameter", "sweptAngle", "deflection", "closestApproach"]
          ++ ["crossings[" ++ n ++ "]." ++ key | n <- ["1", "2"], key <- ["r", "azimuth", "g"]]
          ++ ["steps", "angularMomentumDrift", "energyDrift"]
    it "has three columns for the leapfrog" $ do
      rows <- lines <$> text (camera ++ ["--integrator", "leapfrog"])
      take 1 rows `shouldSatisfy` all (\r -> words r == ["leapfrog", "exact", "error"])
      map (length . words) (drop 1 rows) `shouldSatisfy` all (== 4)
  describe "--path" $ do
    it "is a table of angles and places, from start to end" $ do
      rows <- lines . Lazy.unpack <$> csv camera
      take 1 rows `shouldBe` ["swept_angle_rad,r,x,y,z"]
      let points = mapMaybe (mapM readMaybe . fields) (drop 1 rows) :: [[Double]]
      length points `shouldBe` length rows - 1
      points `shouldSatisfy` all onItsRadius
      take 1 points `shouldSatisfy` all startsAtCamera
      length points `shouldSatisfy` (> 100)
    it "follows the leapfrog where that is asked for" $ do
      exact <- csv camera
      stepped <- csv (camera ++ ["--integrator", "leapfrog"])
      exact `shouldSatisfy` (/= stepped)
  describe "mistakes name the option, the value and the range" $ do
    refuses ["--impact=-1"] [("--impact", "-1")]
    refuses ["--impact", "nan"] [("--impact", "NaN")]
    refuses ["--impact", "inf"] [("--impact", "Infinity")]
    refuses [] [("--impact", "nothing")]
    refuses ("--impact" : "3" : camera) [("--impact", "together with --distance or --psi")]
    refuses ["--distance", "1", "--inclination", "80", "--psi", "10", "--eta", "0"] [("--distance", "1")]
    refuses ["--distance", "20"] [("--inclination", "nothing"), ("--psi", "nothing"), ("--eta", "nothing")]
    refuses ["--distance", "20", "--inclination", "181", "--psi=-1", "--eta", "nan"] [("--inclination", "181"), ("--psi", "-1"), ("--eta", "NaN")]
    refuses ["--impact", "3", "--step", "0.1"] [("--step", "0.1")]
    refuses ["--impact", "3", "--integrator", "leapfrog", "--step", "0"] [("--step", "0")]
    refuses ["--impact", "3", "--path", ""] [("--path", "an empty name")]
    it "in one line" $ case resolvePhoton <$> parsed ["--impact=-1"] of
      Just (Left [problem]) -> renderProblem problem `shouldSatisfy` (\s -> "--impact: -1 is not " `isPrefixOf` s && "1e6" `isInfixOf` s && '\n' `notElem` s)
      _ -> expectationFailure "not one problem"
  where
    camera = ["--distance", "20", "--inclination", "80", "--psi", "10", "--eta", "-90"]
    reportKeys = ["fate", "impactParameter", "sweptAngle", "deflection", "closestApproach", "crossings", "steps", "angularMomentumDrift", "energyDrift"]
    parsed arguments = getParseResult (execParserPure defaultPrefs (info photonOptions mempty) arguments)
    outcome arguments = case resolvePhoton <$> parsed arguments of
      Just (Right task) -> pure (photonOutcome task)
      Just (Left problems) -> fail (concatMap renderProblem problems)
      Nothing -> fail "not parsed"
    text arguments = outcomeText False <$> outcome arguments
    csv arguments = outcomeCsv <$> outcome arguments
    json arguments = do
      printed <- outcomeText True <$> outcome arguments
      maybe (fail ("not JSON: " ++ printed)) pure (readJson printed)
    at path arguments = json arguments >>= maybe (fail "no number there") pure . numberAt path
    keys report = case report of
      Object members -> map fst members
      _ -> []
    refuses arguments problems =
      it (unwords ("photon" : arguments)) $
        case resolvePhoton <$> parsed arguments of
          Just (Left found) -> map (\p -> (problemOption p, problemValue p)) found `shouldBe` problems
          _ -> expectationFailure "taken"
    onItsRadius point = case point of
      [_, r, x, y, z] -> abs (r - sqrt (x * x + y * y + z * z)) < 1e-9 * r
      _ -> False
    startsAtCamera point = case point of
      angle : r : _ -> angle == 0 && abs (r - 20) < 1e-12
      _ -> False
    fields s = case break (== ',') s of
      (field, _ : rest) -> field : fields rest
      (field, []) -> [field]
